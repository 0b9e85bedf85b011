// SPDX-License-Identifier: BSD-3-Clause
// Odometry, mounts and scans out of a bag.
#include <cmath>

#include "eval/bag_log_fixture.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(BagLog, InterpolatesOdometryFromTf) {
  writeDrive();
  const Log log = readLog(request_);
  EXPECT_THAT(log.warnings, IsEmpty());
  ASSERT_EQ(log.scans.size(), 30U);
  for (const auto& scan : log.scans) {
    EXPECT_NEAR(scan.T_odom_base.x, scan.scan.stamp - 100.0, 1e-6);
    EXPECT_NEAR(scan.mount.position.x(), 0.2, 1e-9);
    EXPECT_NEAR(scan.mount.position.y(), 0.1, 1e-9);
    EXPECT_FALSE(scan.T_map_base);
  }
  EXPECT_FLOAT_EQ(static_cast<float>(log.scans[0].scan.range_max), 8.0F);
  EXPECT_EQ(log.scans[0].scan.ranges.size(), 5U);
}

TEST_F(BagLog, HasTheIntensitiesOfScansIfAskedFor) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    for (int i = 0; i < 4; ++i) bag.odometryTransform(10.0 + i, {});
    sensor_msgs::LaserScan scan;
    scan.header.stamp = ros::Time(11.5);
    scan.header.frame_id = "laser";
    scan.angle_increment = 0.1F;
    scan.range_max = 8.0F;
    scan.ranges = {1.0F, 2.0F};
    scan.intensities = {40.0F, 200.0F};
    bag.write("/scan", 11.5, scan);
  }
  EXPECT_THAT(readLog(request_).scans.at(0).scan.intensities, IsEmpty());
  request_.has_intensities = true;
  EXPECT_THAT(readLog(request_).scans.at(0).scan.intensities, testing::ElementsAre(40.0F, 200.0F));
}

TEST_F(BagLog, CutByBeginStillSeesTheStaticTransformsBefore) {
  writeDrive();
  request_.begin = 101.95;
  request_.end = 102.55;
  const Log log = readLog(request_);
  ASSERT_EQ(log.scans.size(), 7U);
  EXPECT_NEAR(log.scans.front().scan.stamp, 101.95, 1e-6);
  EXPECT_NEAR(log.scans.back().scan.stamp, 102.55, 1e-6);
  EXPECT_NEAR(log.scans.front().mount.position.x(), 0.2, 1e-9);
  EXPECT_THAT(log.warnings, IsEmpty());
}

TEST_F(BagLog, StaticTransformsCountWheneverTheyWereRecorded) {
  {
    BagWriter bag(request_.file);
    for (int i = 0; i < 4; ++i) bag.odometryTransform(10.0 + i, {});
    for (int i = 0; i < 3; ++i) bag.scan("/scan", 10.5 + i);
    bag.laserTransform(20.0);
  }
  const Log log = readLog(request_);
  ASSERT_EQ(log.scans.size(), 3U);
  EXPECT_NEAR(log.scans[0].mount.position.x(), 0.2, 1e-9);
}

TEST_F(BagLog, FallsBackToTheOdometryTopic) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    bag.odometry("/odom", 10.0, {1.0, 0.0, 3.1});
    bag.odometry("/odom", 11.0, {2.0, 0.0, -3.1});
    bag.scan("/scan", 10.5);
    bag.scan("/scan", 11.5);
  }
  const Log log = readLog(request_);
  ASSERT_EQ(log.scans.size(), 1U);
  EXPECT_NEAR(log.scans[0].T_odom_base.x, 1.5, 1e-6);
  EXPECT_NEAR(std::abs(log.scans[0].T_odom_base.theta), kPi, 1e-6);
  EXPECT_NEAR(log.scans[0].mount.position.x(), 0.2, 1e-9);
  EXPECT_EQ(log.skipped, 1);
  EXPECT_THAT(log.warnings, Contains(HasSubstr("for want of odometry at their stamps: 1")));
}

TEST_F(BagLog, PrefersTfUnlessTheTopicIsNamed) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    for (double stamp : {10.0, 11.0}) {
      bag.odometryTransform(stamp, {1.0, 0.0, 0.0});
      bag.odometry("/odom", stamp, {2.0, 0.0, 0.0});
    }
    bag.scan("/scan", 10.5);
  }
  EXPECT_DOUBLE_EQ(readLog(request_).scans.at(0).T_odom_base.x, 1.0);
  request_.odom_topic = "odom";
  EXPECT_DOUBLE_EQ(readLog(request_).scans.at(0).T_odom_base.x, 2.0);
}

TEST_F(BagLog, SaysWhenThereIsNoOdometry) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    bag.scan("/scan", 10.5);
  }
  expectRejected("no transform from 'odom' to 'base_link'");
}

TEST_F(BagLog, FollowsChainsOfFramesAndOtherNames) {
  {
    BagWriter bag(request_.file);
    bag.transform("/tf_static", 10.0, "/footprint", "/base", 0.0, 0.5, yaw(0.0));
    bag.transform("/tf_static", 10.0, "/base", "/laser", 0.3, 0.0, yaw(kPi));
    for (double stamp : {10.0, 11.0}) {
      bag.transform("/tf", stamp, "/wheels", "/footprint", 1.0, 0.0, yaw(kPi / 2));
    }
    bag.scan("/scan", 10.5, 5, "/laser");
  }
  request_.frames.odom_frame_id = "wheels";
  request_.frames.base_frame_id = "/base";
  const Log log = readLog(request_);
  ASSERT_EQ(log.scans.size(), 1U);
  EXPECT_NEAR(log.scans[0].T_odom_base.x, 0.5, 1e-9);
  EXPECT_NEAR(log.scans[0].T_odom_base.theta, kPi / 2, 1e-9);
  EXPECT_NEAR(log.scans[0].mount.axes(0, 0), -1.0, 1e-9);
}

TEST_F(BagLog, KnowsALaserMountedUpsideDown) {
  {
    BagWriter bag(request_.file);
    geometry_msgs::Quaternion rolled;
    rolled.x = 1.0;
    bag.transform("/tf_static", 10.0, "base_link", "laser", 0.1, 0.0, rolled);
    for (double stamp : {10.0, 11.0}) bag.odometryTransform(stamp, {});
    bag.scan("/scan", 10.5);
  }
  const Eigen::Matrix2d axes = readLog(request_).scans.at(0).mount.axes;
  EXPECT_NEAR((axes - LaserMount::upsideDown({}).axes).norm(), 0.0, 1e-9);
}

TEST_F(BagLog, TakesAMountThatIsStampedAhead) {
  {
    BagWriter bag(request_.file);  // as static_transform_publisher of old does
    bag.transform("/tf", 10.6, "base_link", "laser", 0.135, 0.0, yaw(0.0), 10.0);
    for (double stamp : {10.0, 11.0}) bag.odometryTransform(stamp, {});
    bag.scan("/scan", 10.5);
  }
  EXPECT_NEAR(readLog(request_).scans.at(0).mount.position.x(), 0.135, 1e-9);
}

TEST_F(BagLog, SaysThatTheMountIsAGuess) {
  {
    BagWriter bag(request_.file);
    for (double stamp : {10.0, 11.0}) bag.odometryTransform(stamp, {});
    bag.scan("/scan", 10.5, 5, "lidar");
  }
  const Log log = readLog(request_);
  EXPECT_EQ(log.scans.size(), 1U);
  EXPECT_THAT(log.warnings, Contains(AllOf(HasSubstr("lidar"), HasSubstr("base_link"))));
}

TEST_F(BagLog, KeepsScansOfAlternatingShape) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    for (double stamp : {10.0, 11.0, 12.0}) bag.odometryTransform(stamp, {});
    bag.scan("/scan", 10.5, 181);
    bag.scan("/scan", 11.5, 180);
  }
  const Log log = readLog(request_);
  ASSERT_EQ(log.scans.size(), 2U);
  EXPECT_EQ(log.scans[0].scan.ranges.size(), 181U);
  EXPECT_EQ(log.scans[1].scan.ranges.size(), 180U);
}

TEST_F(BagLog, SweepsLongerThanTheTimeBetweenScansAreNotBelieved) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(100.0);
    for (int i = 0; i <= 30; ++i) bag.odometryTransform(100.0 + 0.1 * i, {0.1 * i, 0.0, 0.0});
    sensor_msgs::LaserScan scan;
    scan.header.frame_id = "laser";
    scan.range_max = 8.0F;
    scan.angle_increment = 0.01F;
    scan.ranges.assign(101, 2.0F);
    for (int i = 0; i < 20; ++i) {
      scan.header.stamp = ros::Time(100.05 + 0.1 * i);
      scan.time_increment = i < 10 ? 0.001F : 0.005F;  // a sweep of 0.1 or 0.5 s, every 0.1 s
      bag.write("/scan", scan.header.stamp.toSec(), scan);
    }
  }
  const Log log = readLog(request_);
  ASSERT_EQ(log.scans.size(), 20U);
  EXPECT_NEAR(log.scans[9].scan.time_increment, 0.001, 1e-6);
  EXPECT_EQ(log.scans[10].scan.time_increment, 0.0);
  EXPECT_THAT(log.warnings,
              Contains(AllOf(HasSubstr("time_increment"), HasSubstr("between scans: 10"))));
}

TEST_F(BagLog, SaysHowManyTransformsAreOfNoUse) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    for (double stamp : {10.0, 11.0}) bag.odometryTransform(stamp, {});
    bag.odometryTransform(10.2, {std::nan(""), 0.0, 0.0});
    bag.odometryTransform(10.4, {0.0, 0.0, std::nan("")});
    bag.scan("/scan", 10.5);
  }
  const Log log = readLog(request_);
  ASSERT_EQ(log.scans.size(), 1U);
  EXPECT_TRUE(isFinite(log.scans[0].T_odom_base));
  EXPECT_THAT(log.warnings, Contains(HasSubstr("transforms ignored")));
}

}  // namespace
}  // namespace adaptive_localization
