// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <string>

#include "adaptive_localization/filters/builtins.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

using Values = std::map<std::string, OptionValue>;

std::unique_ptr<Filter> makeSwarm(const std::string& name, const std::string& preset,
                                  const Values& more = {}, std::uint64_t seed = 1) {
  const FilterDescription& description = builtins().filters.find(name);
  FilterContext context{builtins(), asymmetricWorld(), {}, seed};
  for (const auto& [key, value] : description.preset(preset)) {
    context.parameters.set(key, value);
  }
  for (const auto& [key, value] : more) context.parameters.set(key, value);
  return description.make(context);
}

Gaussian2 exactly(const Pose2& mean) {
  return {mean, Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal()};
}

Observations seenAt(const Pose2& pose) {
  return ToyLaser{61, -2.0, 2.0, 12.0}.observe(asymmetricWorld(), pose);
}

class SwarmFilters : public testing::TestWithParam<const char*> {};

TEST_P(SwarmFilters, FindTheRobotInOneScan) {
  const Pose2 truth{7.0, 1.0, 2.0};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto filter = makeSwarm(GetParam(), "recommended", {}, seed);
    filter->reset(Anywhere{});
    const Estimate estimate = filter->update({}, seenAt(truth));
    EXPECT_THAT(estimate.T_map_base, PoseNear(truth, 0.05, 0.02)) << "seed " << seed;
    EXPECT_LT(std::sqrt(estimate.covariance(0, 0)), 0.05);
  }
}

TEST_P(SwarmFilters, TrackToCentimetres) {
  const auto drive = toyDrive(asymmetricWorld(), 3, 61);
  const auto filter = makeSwarm(GetParam(), "recommended");
  filter->reset(exactly(drive.front().T_map_base));
  double squares = 0.0;
  for (const ToyStep& step : drive) {
    const Pose2 pose = filter->update(step.motion, step.observations).T_map_base;
    squares += std::pow(distance(pose, step.T_map_base), 2);
  }
  // The toy laser sees cells' faces, a match takes walls to be in the middle of the cells of 0.1 m.
  EXPECT_LT(std::sqrt(squares / static_cast<double>(drive.size())), 0.035);
}

TEST_P(SwarmFilters, FollowTheRobotThroughACrowd) {
  const auto filter = makeSwarm(GetParam(), "recommended");
  const auto drive = toyDrive(asymmetricWorld(), 3, 61);
  filter->reset(exactly(drive.front().T_map_base));
  Rng rng(5);
  for (ToyStep step : drive) {
    Scan& scan = step.observations.scan;
    for (Eigen::Index i = 0; i < scan.range.size(); ++i) {
      if (i % 10 > 3) continue;  // legs in two of five directions
      const auto share = static_cast<float>(rng.uniform(0.3, 0.8));
      scan.range[i] *= share;
      scan.x[i] *= share;
      scan.y[i] *= share;
    }
    const Pose2 pose = filter->update(step.motion, step.observations).T_map_base;
    ASSERT_LT(distance(pose, step.T_map_base), 0.15);
  }
}

TEST_P(SwarmFilters, RideOnOdometryUntilItIsTooUncertain) {
  const auto filter = makeSwarm(GetParam(), "seed", {{"swarm_fix_deviation", 0.1}});
  Pose2 truth{2.0, 1.0, 0.0};
  filter->reset(exactly(truth));
  const auto deviation = [&] { return std::sqrt(filter->estimate().covariance(0, 0)); };
  filter->update({}, seenAt(truth));
  double before = deviation();
  int grown = 0, fixes = 0;
  for (int i = 0; i < 60; ++i) {
    const Pose2 motion{i % 20 < 10 ? 0.1 : -0.1, 0.0, 0.0};
    truth = truth * motion;
    filter->update(motion, seenAt(truth));
    grown += deviation() > before ? 1 : 0;
    fixes += deviation() < before ? 1 : 0;
    before = deviation();
    ASSERT_LT(before, 0.13);
    ASSERT_THAT(filter->estimate().T_map_base, PoseNear(truth, 0.2, 0.1));
  }
  EXPECT_GT(grown, 40);
  EXPECT_GT(fixes, 0);
}

INSTANTIATE_TEST_SUITE_P(Names, SwarmFilters, testing::Values("pso", "ba", "lbba"));

TEST(SwarmFilter, LeadersAreSomeOfTheBats) {
  const auto filter = makeSwarm("lbba", "recommended", {{"swarm_size", 500}});
  EXPECT_EQ(filter->leaders().size(), 0);
  filter->reset(Anywhere{});
  filter->update({}, seenAt({7.0, 1.0, 2.0}));
  const Particles leaders = filter->leaders();
  ASSERT_EQ(leaders.size(), 10);
  const Particles& bats = filter->hypotheses();
  for (Eigen::Index j = 0; j < leaders.size(); ++j) {
    EXPECT_EQ((bats.x - leaders.x[j]).abs().minCoeff(), 0.0);
  }
  const auto no_leaders = makeSwarm("ba", "recommended");
  no_leaders->reset(Anywhere{});
  no_leaders->update({}, seenAt({7.0, 1.0, 2.0}));
  EXPECT_EQ(no_leaders->leaders().size(), 0);
}

TEST(SwarmFilter, DoesNotWeighAFixAgainstItself) {
  const Pose2 truth{2.0, 1.0, 0.3};
  const std::map<std::string, int> scans{{"hits", 4}, {"ranges", 2}};  // until the slip is seen
  for (const auto& [near, count] : scans) {
    const auto filter =
        makeSwarm("lbba", "recommended", {{"swarm_match", false}, {"swarm_near", near}});
    filter->reset(exactly(truth));
    filter->update({}, seenAt(truth));
    const Pose2 slip{0.25, 0.0, 0.0};  // which odometry does not see
    for (int i = 0; i < count; ++i) filter->update({}, seenAt(truth * slip));
    const Estimate estimate = filter->estimate();
    EXPECT_THAT(estimate.T_map_base, PoseNear(truth * slip, 0.05, 0.03)) << near;
    EXPECT_GE(std::sqrt(estimate.covariance(0, 0)), 0.04) << near;  // what a swarm can tell
    EXPECT_GE(std::sqrt(estimate.covariance(2, 2)), 0.02) << near;
  }
}

TEST(SwarmFilter, FindsWithRayCastingWhatItFindsWithTheTable) {
  const Pose2 truth{7.0, 1.0, 2.0};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto filter =
        makeSwarm("lbba", "recommended", {{"swarm_ranges", std::string("cast")}}, seed);
    filter->reset(Anywhere{});
    EXPECT_THAT(filter->update({}, seenAt(truth)).T_map_base, PoseNear(truth, 0.05, 0.02));
    EXPECT_GE(filter->hypotheses().size(), 100);
  }
}

}  // namespace
}  // namespace adaptive_localization
