// SPDX-License-Identifier: BSD-3-Clause
#include "core/heading_history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class Headings : public testing::Test {
 protected:
  void expectRefused(double stamp, const Heading& heading, const std::string& why) {
    try {
      history_.addHeading(stamp, heading);
      ADD_FAILURE() << "expected: " << why;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(why));
    }
  }

  HeadingHistory history_;
};

TEST_F(Headings, AreInterpolatedTheShortWayRound) {
  history_.addHeading(10.0, {kPi - 0.1, 0.1});
  history_.addHeading(10.2, {-kPi + 0.1, 0.3});
  const auto reading = history_.headingAt(10.15);
  ASSERT_TRUE(reading);
  EXPECT_NEAR(wrapAngle(reading->heading.theta - (-kPi + 0.05)), 0.0, 1e-9);
  EXPECT_EQ(reading->heading.deviation, 0.3);
  EXPECT_EQ(reading->stamp, 10.15);
}

TEST_F(Headings, HoldForHalfASecond) {
  history_.addHeading(10.0, {1.0, 0.1});
  ASSERT_TRUE(history_.headingAt(10.4));
  EXPECT_EQ(history_.headingAt(10.4)->stamp, 10.0);
  EXPECT_TRUE(history_.headingAt(9.7));
  EXPECT_FALSE(history_.headingAt(10.6));
  EXPECT_FALSE(history_.headingAt(9.4));
  history_.clear();
  EXPECT_FALSE(history_.headingAt(10.0));
}

TEST_F(Headings, ThatMakeNoSenseAreRefusedByName) {
  expectRefused(1.0, {kNan, 0.1}, "heading: got nan");
  expectRefused(1.0, {0.0, 0.0}, "standard deviation of a heading: got 0, expected one above 0");
  expectRefused(1.0, {0.0, kNan}, "standard deviation of a heading: got nan");
  expectRefused(kNan, {0.0, 0.1}, "stamp: got nan");
  EXPECT_FALSE(history_.headingAt(1.0));
  history_.addHeading(5.0, {0.0, 0.1});
  expectRefused(5.0, {1.0, 0.1}, "stamp: got 5, expected one after the last, 5");
  expectRefused(4.0, {1.0, 0.1}, "stamp: got 4");
  EXPECT_EQ(history_.headingAt(5.0)->heading.theta, 0.0);
}

TEST_F(Headings, OneThatIsRefusedLeavesTheOthers) {
  history_.addHeading(10.0, {1.0, 0.1});
  history_.addRate(10.0, 0.5, 0.1);
  expectRefused(1.0, {kNan, 0.1}, "heading: got nan");  // with a stamp that would begin anew
  EXPECT_THROW(history_.addRate(1.0, kNan, 0.1), std::invalid_argument);
  EXPECT_TRUE(history_.headingAt(10.0));
  EXPECT_TRUE(history_.turnAt(10.1));
}

TEST_F(Headings, OneFromTheFutureDoesNotSilenceThoseThatFollow) {
  history_.addHeading(1e9, {1.0, 0.1});
  history_.addRate(1e9, 1.0, 0.1);
  history_.addHeading(5.0, {2.0, 0.1});
  history_.addRate(5.0, 0.5, 0.1);
  EXPECT_EQ(history_.headingAt(5.0)->heading.theta, 2.0);
  EXPECT_NEAR(history_.turnAt(5.1)->angle, 0.05, 1e-9);
}

TEST_F(Headings, OfLongAgoAreForgotten) {
  for (int i = 0; i < 200; ++i) history_.addHeading(i, {0.0, 0.1});
  EXPECT_FALSE(history_.headingAt(100.0));
  EXPECT_TRUE(history_.headingAt(150.0));
  EXPECT_EQ(history_.lastHeading(), 199.0);
}

TEST_F(Headings, RatesAreSummedUp) {
  for (int i = 0; i <= 10; ++i) history_.addRate(1.0 + 0.1 * i, 0.5, 0.01);
  const auto begin = history_.turnAt(1.0);
  const auto end = history_.turnAt(2.05);
  ASSERT_TRUE(begin && end);
  EXPECT_NEAR(end->angle - begin->angle, 0.5 * 1.05, 1e-9);
  EXPECT_EQ(end->since, 1.0);
  EXPECT_EQ(end->deviation, 0.01);
  EXPECT_FALSE(history_.turnAt(0.9));
}

TEST_F(Headings, ASilentGyroscopeBeginsAnew) {
  history_.addRate(1.0, 0.5, 0.01);
  history_.addRate(3.0, 0.5, 0.01);
  EXPECT_FALSE(history_.turnAt(2.0));
  ASSERT_TRUE(history_.turnAt(3.0));
  EXPECT_EQ(history_.turnAt(3.0)->since, 3.0);
  EXPECT_EQ(history_.turnAt(3.0)->angle, 0.0);
}

}  // namespace
}  // namespace adaptive_localization
