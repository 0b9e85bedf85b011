// SPDX-License-Identifier: BSD-3-Clause
#include "eval/carryings.hpp"

#include <gtest/gtest.h>

#include "eval/json.hpp"

namespace adaptive_localization {
namespace {

/// A run that drives along x at a metre per second, and is carried on by some metres at some of the
/// seconds; off by `errors`, m, at each.
std::vector<RunStep> run(const std::vector<double>& carried, const std::vector<double>& errors) {
  std::vector<RunStep> steps;
  double x = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    RunStep step;
    step.stamp = 100.0 + static_cast<double>(i);
    x += 1.0 + carried[i];
    step.T_odom_base = {static_cast<double>(i), 0.0, 0.0};
    step.T_map_base_reference = Pose2{x, 2.0, 0.3};
    step.T_map_base = {x, 2.0 + errors[i], 0.3};
    steps.push_back(step);
  }
  for (RunStep& step : steps) {  // odometry has a frame of its own
    step.T_odom_base = Pose2{5.0, 1.0, 0.7} * step.T_odom_base;
  }
  return steps;
}

TEST(Carryings, AreNoneWhereTheReferenceFollowsTheOdometry) {
  const Carryings carryings = carryingsOf(run({0, 0.3, 0, -0.4}, {0, 0, 9, 0}));
  EXPECT_EQ(carryings.times, 0);
  EXPECT_EQ(carryings.found, 0);
  EXPECT_FALSE(carryings.found_after_s);
  EXPECT_EQ(toText(carryings), "");
  EXPECT_EQ(carryingsOf({}).times, 0);
}

TEST(Carryings, CountFromWhereTheRobotIsPutDownUntilItIsFoundForGood) {
  const Carryings carryings =
      carryingsOf(run({0, 0, 7, 0, 0, 0, 0, -5, 0, 0}, {0, 0, 7, 0.1, 6, 0.4, 0, 5, 0.2, 0}));
  EXPECT_EQ(carryings.times, 2);
  EXPECT_EQ(carryings.found, 2);
  EXPECT_DOUBLE_EQ(carryings.found_after_s.value(), 2.0) << "of 3 and 1 s";
  EXPECT_DOUBLE_EQ(carryings.found_after_longest_s.value(), 3.0);
  EXPECT_EQ(toText(carryings),
            "carried away 2 times, found after 2 of them, within 2.0 s in the median, 3.0 s at "
            "most; ");
}

TEST(Carryings, ARobotThatIsLostWhenItIsCarriedAgainWasNotFound) {
  const Carryings carryings = carryingsOf(run({0, 7, 0, 7, 0, 7, 0}, {0, 7, 0, 7, 7, 7, 7}));
  EXPECT_EQ(carryings.times, 3);
  EXPECT_EQ(carryings.found, 1);
  EXPECT_DOUBLE_EQ(carryings.found_after_s.value(), 1.0);
}

TEST(Carryings, ATurnIsOneToo) {
  auto steps = run({0, 0, 0}, {0, 0, 0});
  steps[1].T_map_base_reference->theta += 0.5;
  EXPECT_EQ(carryingsOf(steps).times, 2) << "and the turn back";
}

TEST(Carryings, NothingIsKnownWhereThereIsNoReference) {
  auto steps = run({0, 7, 0, 7, 0}, {0, 7, 7, 7, 7});
  steps[1].T_map_base_reference.reset();
  const Carryings carryings = carryingsOf(steps);
  EXPECT_EQ(carryings.times, 1);
  EXPECT_EQ(carryings.found, 0);
  EXPECT_EQ(toText(carryings), "carried away 1 times, found after 0; ");
}

TEST(Carryings, AreWrittenAsJson) {
  const nlohmann::json json = carryingsOf(run({0, 7, 0}, {0, 7, 0}));
  EXPECT_EQ(json.at("times"), 1);
  EXPECT_EQ(json.at("found"), 1);
  EXPECT_DOUBLE_EQ(json.at("found_after_s"), 1.0);
  const nlohmann::json none = Carryings{};
  EXPECT_TRUE(none.at("found_after_s").is_null());
}

}  // namespace
}  // namespace adaptive_localization
