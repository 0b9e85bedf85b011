// SPDX-License-Identifier: BSD-3-Clause
// Compass and gyroscope out of a bag.
#include <sensor_msgs/Imu.h>

#include "eval/bag_log_fixture.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class BagLogHeadings : public BagLog {
 protected:
  /// Scans and odometry from 100 to 102 s and, 100 times a second, an IMU that sits turned by a
  /// quarter and turns with 0.5 rad/s.
  void write(const std::string& frame = "imu", double variance = 0.01) const {
    BagWriter bag(request_.file);
    bag.laserTransform(100.0);
    bag.transform("/tf_static", 100.0, "base_link", "imu", 0.0, 0.0, yaw(kPi / 2));
    for (int i = 0; i <= 200; ++i) {
      const double stamp = 100.0 + 0.01 * i;
      sensor_msgs::Imu imu;
      imu.header.stamp = ros::Time(stamp);
      imu.header.frame_id = frame;
      imu.orientation = yaw(0.5 * (stamp - 100.0) + kPi / 2);
      imu.angular_velocity.z = 0.5;
      imu.orientation_covariance[8] = variance;
      imu.angular_velocity_covariance[8] = 1e-4;
      bag.write("/imu/data", stamp, imu);
      if (i % 10 == 0) bag.odometryTransform(stamp, {});
      if (i % 10 == 5) bag.scan("/scan", stamp);
    }
  }
};

TEST_F(BagLogHeadings, AreThoseOfTheStampsOfScans) {
  write();
  request_.headings.imu_topic = "imu/data";
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings, IsEmpty());
  ASSERT_EQ(log.scans.size(), 20U);
  for (const LogScan& scan : log.scans) {
    const double turned = 0.5 * (scan.scan.stamp - 100.0);
    ASSERT_TRUE(scan.heading && scan.gyro);
    EXPECT_NEAR(scan.heading->theta, turned, 1e-6);
    EXPECT_NEAR(scan.heading->deviation, 0.1, 1e-9);
    EXPECT_NEAR(scan.gyro->angle, turned, 1e-6);
    EXPECT_NEAR(scan.gyro->deviation, 0.01, 1e-9);
  }
}

TEST_F(BagLogHeadings, AreNotReadUnlessAskedFor) {
  write();
  const Log log = readLog(request_);
  EXPECT_FALSE(log.scans.front().heading);
  EXPECT_FALSE(log.scans.front().gyro);
}

TEST_F(BagLogHeadings, TheUsersDeviationCounts) {
  write("imu", 0.0);
  request_.headings.imu_topic = "/imu/data";
  request_.headings.heading_std = 0.3;
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings, IsEmpty());
  EXPECT_NEAR(log.scans.front().heading->deviation, 0.3, 1e-9);
}

TEST_F(BagLogHeadings, WhatCannotBeUsedIsCounted) {
  write("imu", 0.0);
  request_.headings.imu_topic = "/imu/data";
  const Log log = readLog(request_);
  EXPECT_FALSE(log.scans.front().heading);
  EXPECT_TRUE(log.scans.front().gyro);
  EXPECT_THAT(log.warnings, ElementsAre(HasSubstr("messages of the compass dropped: 201 of 201")));
  EXPECT_THAT(log.warnings, ElementsAre(HasSubstr("heading_std")));
}

TEST_F(BagLogHeadings, AnUnknownFrameIsNamed) {
  write("nowhere");
  request_.headings.imu_topic = "/imu/data";
  const Log log = readLog(request_);
  EXPECT_FALSE(log.scans.front().heading);
  ASSERT_EQ(log.warnings.size(), 2U);
  EXPECT_THAT(log.warnings[0], HasSubstr("nowhere"));
}

TEST_F(BagLogHeadings, ATopicThatIsNotThereIsNamed) {
  write();
  request_.headings.imu_topic = "/compass";
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings, ElementsAre(HasSubstr("no topic '/compass' with headings")));
}

}  // namespace
}  // namespace adaptive_localization
