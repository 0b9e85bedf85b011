// SPDX-License-Identifier: BSD-3-Clause
#include "particle/exploration.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace adaptive_localization {
namespace {

ExplorationOptions rates(double slow, double fast) {
  ExplorationOptions options;
  options.recovery_reference = "mean";
  options.recovery_margin = 1.0;
  options.recovery_alpha_slow = slow;
  options.recovery_alpha_fast = fast;
  return options;
}

/// Tells an exploration of a mean likelihood and of nothing else.
void tell(Exploration& exploration, double mean_likelihood) {
  exploration.observe({Observations{}, mean_likelihood, Pose2{}, 0.0, 100});
}

TEST(Exploration, HasTheEquationsOfAugmentedMcl) {
  const auto exploration = augmentedExploration(rates(0.01, 0.2));
  EXPECT_EQ(exploration->share(), 0.0);  // before anything was seen
  tell(*exploration, 0.8);
  EXPECT_EQ(exploration->share(), 0.0);  // both averages start at the first value
  double slow = 0.8, fast = 0.8;
  for (const double w : {0.7, 0.2, 0.1, 0.1, 0.9}) {
    tell(*exploration, w);
    slow += 0.01 * (w - slow);
    fast += 0.2 * (w - fast);
    EXPECT_NEAR(exploration->share(), std::max(0.0, 1.0 - fast / slow), 1e-12);
  }
  EXPECT_GT(exploration->share(), 0.1);
}

TEST(Exploration, LooksNowhereWhileLikelihoodsRise) {
  const auto exploration = augmentedExploration(rates(0.01, 0.2));
  for (const double w : {0.1, 0.2, 0.4, 0.8}) {
    tell(*exploration, w);
    EXPECT_EQ(exploration->share(), 0.0);
  }
}

TEST(Exploration, StartsAnewAfterItLookedElsewhere) {
  const auto exploration = augmentedExploration(rates(0.01, 0.5));
  tell(*exploration, 0.9);
  tell(*exploration, 0.1);
  ASSERT_GT(exploration->share(), 0.0);
  exploration->explored();
  EXPECT_EQ(exploration->share(), 0.0);
  tell(*exploration, 0.1);
  EXPECT_EQ(exploration->share(), 0.0);
}

TEST(Exploration, RemembersTheBestAndGoesOnLooking) {
  ExplorationOptions options = rates(0.001, 0.5);
  options.recovery_reference = "best";
  const auto exploration = augmentedExploration(options);
  tell(*exploration, 0.01);  // the robot may be anywhere yet
  for (int i = 0; i < 20; ++i) tell(*exploration, 0.8);
  EXPECT_EQ(exploration->share(), 0.0);
  for (int i = 0; i < 10; ++i) tell(*exploration, 0.1);
  EXPECT_NEAR(exploration->share(), 1.0 - 0.1 / 0.8, 0.02);
  exploration->explored();
  EXPECT_GT(exploration->share(), 0.8);
}

TEST(Exploration, ToleratesWhatTheMarginAllows) {
  ExplorationOptions options = rates(0.001, 1.0);
  options.recovery_margin = 3.0;
  const auto exploration = augmentedExploration(options);
  tell(*exploration, 0.9);
  tell(*exploration, 0.31);
  EXPECT_EQ(exploration->share(), 0.0);
  tell(*exploration, 0.1);
  EXPECT_NEAR(exploration->share(), 1.0 - 3.0 * 0.1 / 0.9, 0.01);
}

TEST(Exploration, IsOffAtRateZero) {
  for (const auto& [slow, fast] : {std::pair{0.0, 0.1}, {0.001, 0.0}, {0.0, 0.0}}) {
    const auto exploration = augmentedExploration(rates(slow, fast));
    tell(*exploration, 0.9);
    tell(*exploration, 0.001);
    EXPECT_EQ(exploration->share(), 0.0);
  }
}

TEST(Exploration, OutlivesALikelihoodThatIsNoNumber) {
  const auto exploration = augmentedExploration(rates(0.01, 0.5));
  tell(*exploration, 0.9);
  tell(*exploration, std::numeric_limits<double>::quiet_NaN());
  tell(*exploration, 0.1);
  EXPECT_GT(exploration->share(), 0.0);
}

TEST(NoExploration, NeverLooksElsewhere) {
  const auto none = noExploration();
  tell(*none, 0.9);
  tell(*none, 0.0);
  EXPECT_EQ(none->share(), 0.0);
}

}  // namespace
}  // namespace adaptive_localization
