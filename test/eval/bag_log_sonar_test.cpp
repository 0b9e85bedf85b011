// SPDX-License-Identifier: BSD-3-Clause
// Sonars out of a bag.
#include <sensor_msgs/Range.h>

#include "eval/bag_log_fixture.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class BagLogSonars : public BagLog {
 protected:
  /// A drive of 3 s at 1 m/s, with one ping in the middle between two odometry readings.
  void write(const std::string& frame = "sonar_4", float range = 1.5F) const {
    BagWriter bag(request_.file);
    bag.laserTransform(100.0);
    bag.transform("/tf_static", 100.0, "base_link", "sonar_4", 0.1, 0.0, yaw(0.3));
    for (int i = 0; i <= 30; ++i) {
      const double stamp = 100.0 + 0.1 * i;
      bag.odometryTransform(stamp, {stamp - 100.0, 0.0, 0.0});
      if (i < 30) bag.scan("/scan", stamp + 0.05);
      sensor_msgs::Range message;
      message.header.stamp = ros::Time(stamp + 0.03);
      message.header.frame_id = frame;
      message.field_of_view = 0.5F;
      message.max_range = 5.0F;
      message.range = range;
      bag.write("/sonar", stamp + 0.03, message);
    }
  }
};

TEST_F(BagLogSonars, ComeWithTheNextScanFromWhereTheyPinged) {
  write();
  request_.sonars.sonar_topics = "sonar";
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings, IsEmpty());
  ASSERT_EQ(log.scans.size(), 30U);
  EXPECT_THAT(log.scans[0].sonar, IsEmpty());  // nobody knows where the robot was
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    ASSERT_THAT(log.scans[i].sonar, SizeIs(1)) << i;
    const SonarReading& reading = log.scans[i].sonar[0];
    EXPECT_NEAR(reading.range, 1.5, 1e-6);
    EXPECT_THAT(reading.T_base_sonar, PoseNear(Pose2{0.08, 0.0, 0.3}, 1e-3, 1e-6));
  }
}

TEST_F(BagLogSonars, AreNotReadUnlessAskedFor) {
  write();
  EXPECT_THAT(readLog(request_).scans[5].sonar, IsEmpty());
}

TEST_F(BagLogSonars, WhatCannotBeUsedIsCounted) {
  write("sonar_4", 77.0F);
  request_.sonars.sonar_topics = "/sonar";
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings, ElementsAre(HasSubstr("messages of the sonars dropped: 31 of 31")));
  EXPECT_THAT(log.scans[5].sonar, IsEmpty());
}

TEST_F(BagLogSonars, AnUnknownFrameAndATopicThatIsNotThereAreNamed) {
  write("nowhere");
  request_.sonars.sonar_topics = "/sonar, sonars";
  const Log log = readLog(request_);
  ASSERT_THAT(log.warnings, SizeIs(2));
  EXPECT_THAT(log.warnings[0], HasSubstr("no topic 'sonars' with sonars"));
  EXPECT_THAT(log.warnings[1], HasSubstr("nowhere"));
}

}  // namespace
}  // namespace adaptive_localization
