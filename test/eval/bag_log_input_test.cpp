// SPDX-License-Identifier: BSD-3-Clause
// References, the choice of topics, and bags with something wrong.
#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include <cmath>

#include "adaptive_localization/core/rng.hpp"
#include "eval/bag_log_fixture.hpp"

namespace adaptive_localization {
namespace {

TEST_F(BagLog, TakesReferenceFromATopicWithOrWithoutSlash) {
  writeDrive();
  for (const char* topic : {"/truth", "truth"}) {
    request_.truth_topic = topic;
    const Log log = readLog(request_);
    ASSERT_TRUE(log.scans[3].T_map_base) << topic;
    EXPECT_NEAR(log.scans[3].T_map_base->x, log.scans[3].scan.stamp - 90.0, 1e-6);
    EXPECT_NEAR(log.scans[3].T_map_base->theta, 0.5, 1e-9);
  }
}

TEST_F(BagLog, TakesReferenceOfOtherTypes) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    for (double stamp : {10.0, 11.0, 12.0}) {
      bag.odometryTransform(stamp, {});
      bag.odometry("/ground_truth", stamp, {7.0, 0.0, 0.0});
      geometry_msgs::PoseWithCovarianceStamped pose;
      pose.header.stamp = ros::Time(stamp);
      pose.pose.pose.position.x = 8.0;
      pose.pose.pose.orientation.w = 1.0;
      bag.write("/amcl_pose", stamp, pose);
    }
    bag.scan("/scan", 10.5);
  }
  request_.truth_topic = "/ground_truth";
  EXPECT_DOUBLE_EQ(readLog(request_).scans.at(0).T_map_base->x, 7.0);
  request_.truth_topic = "/amcl_pose";
  EXPECT_DOUBLE_EQ(readLog(request_).scans.at(0).T_map_base->x, 8.0);
}

TEST_F(BagLog, HasNoReferenceInALongGap) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    for (double stamp : {10.0, 10.8, 12.0}) {
      bag.odometryTransform(stamp, {});
      bag.pose("/truth", stamp, {});
    }
    bag.scan("/scan", 10.5);
    bag.scan("/scan", 11.5);
  }
  request_.truth_topic = "/truth";
  const Log log = readLog(request_);
  ASSERT_EQ(log.scans.size(), 2U);
  EXPECT_TRUE(log.scans[0].T_map_base);
  EXPECT_FALSE(log.scans[1].T_map_base);
}

TEST_F(BagLog, AsksWhichOfSeveralScanTopics) {
  {
    BagWriter bag(request_.file);
    bag.laserTransform(10.0);
    for (double stamp : {10.0, 11.0}) bag.odometryTransform(stamp, {});
    bag.scan("/front", 10.5);
    bag.scan("/rear", 10.5, 7);
  }
  expectRejected("--scan-topic: /front, /rear");
  request_.scan_topic = "rear";
  EXPECT_EQ(readLog(request_).scans.at(0).scan.ranges.size(), 7U);
  request_.scan_topic = "/side";
  expectRejected(
      "--scan-topic: got '/side', expected a topic with laser scans of this bag: "
      "/front, /rear");
}

TEST_F(BagLog, NamesAnUnknownReferenceTopic) {
  writeDrive();
  request_.truth_topic = "/nothing";
  expectRejected("--truth-topic: got '/nothing'");
}

TEST_F(BagLog, WantsScans) {
  writeDrive();
  request_.begin = 200.0;
  expectRejected("no usable laser scan between the stamps 200 and inf");
}

TEST_F(BagLog, SaysThatABagIsCutOff) {
  writeDrive();
  std::ifstream whole(request_.file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  for (std::size_t size : {bytes.size() / 2, bytes.size() - 10, std::size_t{20}, std::size_t{0}}) {
    request_.file = folder_.write("cut.bag", bytes.substr(0, size));
    expectRejected("");
  }
}

TEST_F(BagLog, RejectsWhatIsNoBag) {
  request_.file = folder_.write("text.bag", "Hello, I am no bag.\n");
  expectRejected("cannot be read");
}

/// Mostly sane numbers, now and then a wild one.
double number(Rng& rng) {
  const double wild[] = {std::nan(""), INFINITY, -INFINITY, 1e300, 0.0, -1e9};
  return rng.uniform() < 0.9 ? rng.uniform(-10.0, 10.0) : wild[rng.below(6)];
}

double stamp(Rng& rng) {
  const double wild[] = {0.0, 1e-9, 1.5e9, 4.29e9};
  return rng.uniform() < 0.9 ? rng.uniform(100.0, 110.0) : wild[rng.below(4)];
}

std::string frame(Rng& rng) {
  const std::string names[] = {"odom", "base_link", "laser", "", "/", "map", "/odom"};
  return names[rng.below(7)];
}

void writeWildMessages(Rng& rng, BagWriter& bag) {
  for (int i = 0; i < 40; ++i) {
    geometry_msgs::Quaternion rotation = yaw(rng.uniform(-3.0, 3.0));
    if (rng.uniform() < 0.3) rotation.x = number(rng);
    if (rng.uniform() < 0.1) rotation = geometry_msgs::Quaternion();
    const bool is_odometry = rng.uniform() < 0.6;
    bag.transform(rng.uniform() < 0.8 ? "/tf" : "/tf_static", stamp(rng),
                  is_odometry ? "odom" : frame(rng), is_odometry ? "base_link" : frame(rng),
                  number(rng), number(rng), rotation, 100.0 + 0.1 * i);
    bag.scan("/scan", stamp(rng), 2 + rng.below(5), rng.uniform() < 0.7 ? "laser" : frame(rng));
    bag.odometry("/odom", stamp(rng), {number(rng), number(rng), number(rng)});
  }
}

TEST_F(BagLog, GivesFiniteNumbersWhateverTheBagHolds) {
  Rng rng(3);
  std::size_t scans = 0;
  for (int round = 0; round < 300; ++round) {
    {
      BagWriter bag(request_.file);
      writeWildMessages(rng, bag);
    }
    request_.truth_topic = round % 2 ? "/odom" : "";
    request_.odom_topic = round % 3 ? "" : "/odom";
    try {
      const Log log = readLog(request_);
      scans += log.scans.size();
      for (const auto& scan : log.scans) {
        ASSERT_TRUE(isFinite(scan.T_odom_base));
        ASSERT_TRUE(scan.mount.position.allFinite() && scan.mount.axes.allFinite());
        ASSERT_TRUE(isFinite(scan.T_map_base.value_or(Pose2{})));
      }
    } catch (const std::invalid_argument&) {  // a clear message is as good as a reading
    }
  }
  EXPECT_GT(scans, 1000U);
}

}  // namespace
}  // namespace adaptive_localization
