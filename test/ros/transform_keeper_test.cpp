// SPDX-License-Identifier: BSD-3-Clause
#include "ros/transform_keeper.hpp"

#include <console_bridge/console.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace adaptive_localization {
namespace {

class TransformKeeperTest : public testing::Test {
 protected:
  void SetUp() override { ros::Time::init(); }  // the log asks for the time

  void add(double stamp, double x = 0.0) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "odom";
    transform.child_frame_id = "base_link";
    transform.header.stamp = ros::Time(stamp);
    transform.transform.translation.x = x;
    transform.transform.rotation.w = 1.0;
    keeper_.add(transform, false);
  }

  /// So many, a tenth of a second apart.
  void addFrom(double stamp, int count, double x = 0.0) {
    for (int i = 0; i < count; ++i) add(stamp + 0.1 * i, x);
  }

  bool knows(double stamp) const {
    return buffer_.canTransform("odom", "base_link", ros::Time(stamp));
  }

  tf2::BufferCore buffer_;
  TransformKeeper keeper_{buffer_};
};

TEST_F(TransformKeeperTest, OneFromTheFutureHoldsUpTheOthersForASecond) {
  addFrom(1000.0, 10);
  add(4600.0);
  addFrom(1001.0, 15);
  EXPECT_TRUE(knows(1002.35));
  EXPECT_FALSE(knows(4600.0));
}

TEST_F(TransformKeeperTest, ClocksThatWereSetBackAreFollowed) {
  addFrom(1000.0, 10);
  addFrom(900.0, 15);
  EXPECT_TRUE(knows(901.35));
}

TEST_F(TransformKeeperTest, OldOnesAmongNewOnesAreIgnored) {
  for (int i = 0; i < 30; ++i) {
    add(1000.0 + 0.1 * i);
    add(900.0 + 0.1 * i);
  }
  EXPECT_TRUE(knows(1000.0));
  EXPECT_TRUE(knows(1002.9));
}

TEST_F(TransformKeeperTest, WhatIsNoTransformEmptiesNothing) {
  addFrom(1000.0, 10);
  for (int i = 10; i < 30; ++i) add(1000.0 + 0.1 * i, std::nan(""));
  EXPECT_TRUE(knows(1000.0));
}

/// Some drivers send each transform twice: tf2 would write a line for each.
TEST_F(TransformKeeperTest, WhatComesTwiceIsNotLogged) {
  struct Lines : console_bridge::OutputHandler {
    void log(const std::string& text, console_bridge::LogLevel, const char*, int) override {
      lines.push_back(text);
    }
    std::vector<std::string> lines;
  } log;
  console_bridge::useOutputHandler(&log);
  addFrom(1000.0, 3);
  add(1000.2);
  addFrom(1000.3, 3);
  EXPECT_TRUE(log.lines.empty()) << log.lines.front();
  add(900.0);
  console_bridge::restorePreviousOutputHandler();
  EXPECT_EQ(log.lines.size(), 1U) << "nothing is heard of tf2";
  EXPECT_TRUE(knows(1000.45));
}

TEST_F(TransformKeeperTest, StampAtTheEndOfTimeIsIgnored) {
  addFrom(1000.0, 10);
  add(4294967295.0);
  addFrom(1001.0, 2);
  EXPECT_TRUE(knows(1001.1));
}

/// Scans between were placed on a way that nobody drove.
TEST_F(TransformKeeperTest, OdometryThatStandsAtItsOriginAfterAPauseWasStartedAnew) {
  addFrom(1000.0, 10, 3.0);
  EXPECT_FALSE(keeper_.restartBelow("odom"));
  addFrom(1004.0, 5);
  ASSERT_TRUE(keeper_.restartBelow("odom"));
  EXPECT_NEAR(keeper_.restartBelow("odom")->before.toSec(), 1000.9, 1e-6);
  EXPECT_NEAR(keeper_.restartBelow("odom")->after.toSec(), 1004.0, 1e-6);
  EXPECT_FALSE(keeper_.restartBelow("map"));
  addFrom(1004.5, 5, 0.1);
  EXPECT_NEAR(keeper_.restartBelow("odom")->after.toSec(), 1004.0, 1e-6) << "the last one";
}

TEST_F(TransformKeeperTest, DrivingPastTheOriginIsNoRestart) {
  for (int i = -30; i < 30; ++i) add(1000.0 + 0.1 * i, 0.1 * i);
  EXPECT_FALSE(keeper_.restartBelow("odom"));
  addFrom(1005.0, 10, 3.0);
  EXPECT_FALSE(keeper_.restartBelow("odom")) << "a pause alone";
}

TEST_F(TransformKeeperTest, WhatIsForgottenWasNotStartedAnew) {
  addFrom(1000.0, 10, 3.0);
  keeper_.clear();
  addFrom(1004.0, 5);
  EXPECT_FALSE(keeper_.restartBelow("odom"));
}

}  // namespace
}  // namespace adaptive_localization
