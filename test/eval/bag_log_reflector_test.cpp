// SPDX-License-Identifier: BSD-3-Clause
// Reflectors in the scans of a bag.
#include <sensor_msgs/LaserScan.h>

#include <cmath>

#include "eval/bag_log_fixture.hpp"
#include "support/sighted_points.hpp"

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

class BagLogReflectors : public BagLog {
 protected:
  BagLogReflectors() {
    request_.landmark_map = LandmarkMap({{3, {5.0, 0.0}}, {4, {7.0, 1.0}}});
    request_.landmarks.reflector_intensity = 100.0;
  }

  /// Two scans of five beams of 2 m, the middle one bright, from a laser at (0.2, 0.1), whose mount
  /// is recorded last; and a picture before the second.
  void write() const {
    BagWriter bag(request_.file);
    for (int i = 0; i <= 10; ++i) bag.odometryTransform(100.0 + 0.1 * i, {});
    for (const double stamp : {100.25, 100.75}) {
      sensor_msgs::LaserScan scan;
      scan.header.stamp = ros::Time(stamp);
      scan.header.frame_id = "laser";
      scan.angle_min = -1.0F;
      scan.angle_increment = 0.5F;
      scan.range_max = 8.0F;
      scan.ranges.assign(5, 2.0F);
      scan.intensities = {10.0F, 20.0F, 200.0F, 20.0F, 99.0F};
      bag.write("/scan", stamp, scan);
    }
    bag.write("/landmarks", 100.7, toMessage(100.7, "base_link", {{4.0F, {2.0F, 0.0F}}}));
    bag.laserTransform(101.0, "/tf");
  }
};

TEST_F(BagLogReflectors, AreWhatIsBrightInAScan) {
  write();
  const Log log = readLog(request_);
  ASSERT_THAT(log.scans, SizeIs(2));
  for (const LogScan& scan : log.scans) {
    ASSERT_TRUE(scan.landmarks);
    ASSERT_THAT(*scan.landmarks, SizeIs(1));
    EXPECT_EQ(scan.landmarks->front().id, -1);
    EXPECT_NEAR(scan.landmarks->front().range, std::hypot(2.2, 0.1), 1e-6);
    EXPECT_NEAR(scan.landmarks->front().bearing, std::atan2(0.1, 2.2), 1e-6);
  }
}

TEST_F(BagLogReflectors, ComeBesideLandmarks) {
  write();
  request_.landmarks.landmark_topic = "/landmarks";
  const Log log = readLog(request_);
  ASSERT_THAT(log.scans, SizeIs(2));
  ASSERT_TRUE(log.scans[0].landmarks && log.scans[1].landmarks);
  EXPECT_THAT(*log.scans[0].landmarks, SizeIs(1));
  EXPECT_THAT(*log.scans[1].landmarks,
              ElementsAre(testing::Field(&Sighting::id, -1), testing::Field(&Sighting::id, 4)));
}

TEST_F(BagLogReflectors, AreNoneUnlessAskedForOrWithoutAMapOfThem) {
  write();
  request_.landmarks.reflector_intensity = 0.0;
  EXPECT_FALSE(readLog(request_).scans[0].landmarks);
  request_.landmarks.reflector_intensity = 100.0;
  request_.landmark_map = {};
  EXPECT_FALSE(readLog(request_).scans[0].landmarks);
}

}  // namespace
}  // namespace adaptive_localization
