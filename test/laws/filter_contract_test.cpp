// SPDX-License-Identifier: BSD-3-Clause
// What every filter must keep, whatever its name and preset.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "adaptive_localization/filters/builtins.hpp"
#include "core/parallel.hpp"
#include "support/pose_matchers.hpp"
#include "support/temp_folder.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

using Case = std::tuple<std::string, std::string>;  // filter, preset

std::vector<std::string> allFilters() {
  return builtins().filters.names();
}

using Values = std::map<std::string, OptionValue>;

std::unique_ptr<Filter> makeFilter(const Case& which, int max_particles, std::uint64_t seed = 1,
                                   const Values& more = {}) {
  const auto& [name, preset] = which;
  const FilterDescription& description = builtins().filters.find(name);
  FilterContext context{builtins(), asymmetricWorld(), {}, seed};
  for (const auto& [key, value] : description.preset(preset)) {
    context.parameters.set(key, value);
  }
  context.parameters.set("min_particles", OptionValue{100});
  context.parameters.set("max_particles", OptionValue{max_particles});
  for (const auto& [key, value] : more) context.parameters.set(key, value);
  return description.make(context);
}

Gaussian2 roughly(const Pose2& mean) {
  return {mean, Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal()};
}

class EveryFilter : public testing::TestWithParam<Case> {};

TEST_P(EveryFilter, IsSaneWhateverItIsGiven) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto map = asymmetricWorld();
  const Observations good = ToyLaser{31}.observe(map, {1.0, 1.0, 0.0});
  Observations no_numbers = good;
  no_numbers.scan.x.setConstant(std::numeric_limits<float>::quiet_NaN());
  no_numbers.scan.y.setConstant(std::numeric_limits<float>::quiet_NaN());
  Observations invalid;
  invalid.scan.invalid = 31;
  Observations blind = ToyLaser{31, -2.0, 2.0, 0.02}.observe(map, {1.0, 1.0, 0.0});

  const auto filter = makeFilter(GetParam(), 300);
  filter->reset(roughly({1.0, 1.0, 0.0}));
  Observations no_heading = good;
  no_heading.heading = Heading{nan, inf};
  for (const Observations& seen :
       {good, Observations{}, invalid, blind, no_numbers, no_heading, good}) {
    ASSERT_THAT(filter->update({0.1, 0.0, 0.1}, seen), IsSaneEstimate());
    ASSERT_THAT(filter->estimate(), IsSaneEstimate());
  }
  for (const double odd : {nan, inf, -inf, 1e3, 1e12, -1e200, 1e308}) {
    for (const Pose2& motion : {Pose2{odd, 0.0, 0.0}, Pose2{0.0, odd, 0.0}, Pose2{0.0, 0.0, odd}}) {
      ASSERT_THAT(filter->update(motion, good), IsSaneEstimate()) << testing::PrintToString(motion);
      ASSERT_THAT(filter->update({0.1, 0.0, 0.0}, good), IsSaneEstimate());
      ASSERT_THAT(filter->estimate(), IsSaneEstimate());
    }
  }
  filter->reset(roughly({1.0, 1.0, 0.0}));
  EXPECT_THAT(filter->update({}, good).T_map_base, PoseNear(Pose2{1.0, 1.0, 0.0}, 0.3, 0.3));
}

TEST_P(EveryFilter, TakesEveryPrior) {
  const auto map = asymmetricWorld();
  const Observations seen = ToyLaser{31}.observe(map, {1.0, 1.0, 0.0});
  const auto filter = makeFilter(GetParam(), 300);
  Gaussian2 narrow{{3.0, 1.0, kPi}, Eigen::Matrix3d::Zero()};
  filter->reset(narrow);
  EXPECT_GT(filter->hypotheses().size(), 0);
  EXPECT_THAT(filter->estimate().T_map_base, PoseNear(narrow.mean, 1e-6, 1e-6));

  Gaussian2 singular = narrow, negative = narrow, no_numbers = narrow, off_map = narrow;
  singular.covariance(0, 0) = 0.04;
  negative.covariance(0, 0) = -1.0;
  no_numbers.covariance.setConstant(std::nan(""));
  off_map.mean = {-500.0, 900.0, 1.0};
  for (const Prior& prior : {Prior{singular}, Prior{negative}, Prior{no_numbers}, Prior{off_map},
                             Prior{roughly({1.0, 1.0, 0.0})}, Prior{Anywhere{}}}) {
    filter->reset(prior);
    ASSERT_GT(filter->hypotheses().size(), 0);
    ASSERT_THAT(filter->estimate(), IsSaneEstimate());
    ASSERT_THAT(filter->update({}, seen), IsSaneEstimate());
    ASSERT_GT(filter->hypotheses().size(), 0);
  }
}

TEST_P(EveryFilter, TakesOverABeliefFromAnother) {
  const auto drive = toyDrive(asymmetricWorld(), 2);
  for (const auto& other : allFilters()) {
    const auto first = makeFilter({other, "recommended"}, 1000);
    first->reset(roughly(drive.front().T_map_base));
    for (std::size_t i = 0; i < 15; ++i) first->update(drive[i].motion, drive[i].observations);
    const auto second = makeFilter(GetParam(), 1000, 2);
    second->reset(first->hypotheses());
    EXPECT_THAT(second->estimate().T_map_base, PoseNear(drive[14].T_map_base, 0.15, 0.087));
    for (std::size_t i = 15; i < 30; ++i) {
      const Estimate estimate = second->update(drive[i].motion, drive[i].observations);
      ASSERT_THAT(estimate.T_map_base, PoseNear(drive[i].T_map_base, 0.15, 0.087))
          << "after " << other << ", step " << i;
    }
  }
}

TEST_P(EveryFilter, TakesOverOddClouds) {
  const Observations seen = ToyLaser{31}.observe(asymmetricWorld(), {1.0, 1.0, 0.0});
  Particles one(1), worthless(50), weighed(2);
  one.setPose(0, {1.0, 1.0, 0.0});
  worthless.log_weight.setConstant(-std::numeric_limits<double>::infinity());
  weighed.setPose(0, {3.0, 1.0, 0.5});
  weighed.setPose(1, {7.0, 1.0, 0.5});
  weighed.log_weight << 5.0, -700.0;
  const auto filter = makeFilter(GetParam(), 300);
  for (const Particles& cloud : {one, worthless, Particles{}, weighed}) {
    filter->reset(cloud);
    ASSERT_THAT(filter->estimate(), IsSaneEstimate());
    ASSERT_THAT(filter->update({}, seen), IsSaneEstimate());
    ASSERT_GE(filter->hypotheses().size(), 100);  // as many as it wants
  }
  filter->reset(weighed);
  EXPECT_THAT(filter->estimate().T_map_base, PoseNear(weighed.pose(0), 1e-6, 1e-6));
}

TEST_P(EveryFilter, StartsAnywhereInFreeSpace) {
  const auto map = asymmetricWorld();
  const auto filter = makeFilter(GetParam(), 1000);
  filter->reset(Anywhere{});
  const Particles& all = filter->hypotheses();
  double leftmost = 10.0, rightmost = 0.0;
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    ASSERT_TRUE(map->isFree(map->lattice().cellAt({all.x[i], all.y[i]})));
    leftmost = std::min(leftmost, all.x[i]);
    rightmost = std::max(rightmost, all.x[i]);
  }
  EXPECT_LT(leftmost, 1.0);
  EXPECT_GT(rightmost, 9.0);
}

TEST_P(EveryFilter, GivesTheSameBitsForTheSameSeedAndAnyNumberOfThreads) {
  const auto drive = toyDrive(asymmetricWorld(), 1, 15);
  const auto run = [&](int threads) {
    setThreads(threads);
    const auto filter = makeFilter(GetParam(), 2500, 42);
    filter->reset(Anywhere{});
    std::vector<double> numbers;
    for (std::size_t i = 0; i < 8; ++i) {
      const Estimate estimate = filter->update(drive[i].motion, drive[i].observations);
      const Pose2& pose = estimate.T_map_base;
      numbers.insert(numbers.end(), {pose.x, pose.y, pose.theta, estimate.covariance.sum(),
                                     estimate.modes[0].mass, filter->hypotheses().x.sum()});
    }
    setThreads(1);
    return numbers;
  };
  const auto once = run(1);
  EXPECT_EQ(once, run(1));
  EXPECT_EQ(once, run(2));
  EXPECT_EQ(once, run(4));
}

TEST_P(EveryFilter, TracksARobotThatItKnowsRoughly) {
  const auto drive = toyDrive(asymmetricWorld(), 2);
  const auto filter = makeFilter(GetParam(), 1000);
  filter->reset(roughly(drive.front().T_map_base));
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const Estimate estimate = filter->update(drive[i].motion, drive[i].observations);
    ASSERT_THAT(estimate, IsSaneEstimate());
    if (i < 10) continue;
    ASSERT_THAT(estimate.T_map_base, PoseNear(drive[i].T_map_base, 0.15, 0.087)) << "step " << i;
  }
}

/// The drive with a compass that is off by some degrees, another at each scan.
TEST_P(EveryFilter, TracksWithAHeadingBesideTheScan) {
  auto drive = toyDrive(asymmetricWorld(), 2);
  Rng rng(9);
  const auto filter = makeFilter(GetParam(), 1000);
  filter->reset(roughly(drive.front().T_map_base));
  for (std::size_t i = 0; i < drive.size(); ++i) {
    drive[i].observations.heading = Heading{drive[i].T_map_base.theta + rng.normal(0.0, 0.1), 0.1};
    const Estimate estimate = filter->update(drive[i].motion, drive[i].observations);
    ASSERT_THAT(estimate, IsSaneEstimate());
    if (i < 10) continue;
    ASSERT_THAT(estimate.T_map_base, PoseNear(drive[i].T_map_base, 0.15, 0.087)) << "step " << i;
  }
}

TEST_P(EveryFilter, ListensToAHeadingWithoutAScan) {
  const auto filter = makeFilter(GetParam(), 2000);
  filter->reset(Gaussian2{{3.0, 1.0, 0.0}, Eigen::Vector3d(0.01, 0.01, 0.09).asDiagonal()});
  Observations told;
  told.heading = Heading{0.3, 0.05};
  Estimate estimate;
  for (int i = 0; i < 3; ++i) estimate = filter->update({0.01, 0.0, 0.0}, told);
  EXPECT_NEAR(estimate.T_map_base.theta, 0.3, 0.06);
  EXPECT_LT(estimate.covariance(2, 2), 0.01);
  EXPECT_NEAR(estimate.T_map_base.x, 3.03, 0.05);
}

/// A landmark in the world, and what is sighted of it.
class EveryFilterWithLandmarks : public testing::TestWithParam<Case> {
 protected:
  EveryFilterWithLandmarks() {
    std::ofstream(file_) << "landmarks:\n  - {id: 3, at: [3.0, 1.5]}\n";
    filter_ = makeFilter(GetParam(), 2000, 1, {{"landmark_map", file_}});
  }

  static Observations sight(const Pose2& T_map_base) {
    const Eigen::Vector2d point = inverse(T_map_base) * Eigen::Vector2d(3.0, 1.5);
    Observations seen;
    seen.landmarks = {{3, point.norm(), std::atan2(point.y(), point.x()), 0.05, 0.02}};
    return seen;
  }

  TempFolder folder_;
  std::string file_ = folder_.file("post.yaml");
  std::unique_ptr<Filter> filter_;
};

TEST_P(EveryFilterWithLandmarks, ListensToThemWithoutAScan) {
  const Pose2 truth{1.0, 1.0, 0.3};
  filter_->reset(Gaussian2{truth, Eigen::Vector3d(1e-4, 1e-4, 0.1).asDiagonal()});
  for (int i = 0; i < 20; ++i) filter_->update({}, sight(truth));
  EXPECT_NEAR(filter_->estimate().T_map_base.theta, truth.theta, 0.06);
}

TEST_P(EveryFilterWithLandmarks, IsSaneWhateverIsSighted) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const Pose2 truth{1.0, 1.0, 0.0};
  filter_->reset(roughly(truth));
  const Sighting good = sight(truth).landmarks->front();
  for (const double odd : {nan, inf, -inf, 0.0, -1.0, 1e-300, 1e300}) {
    for (const auto member : {&Sighting::range, &Sighting::bearing, &Sighting::range_deviation,
                              &Sighting::bearing_deviation}) {
      Observations seen;
      seen.landmarks = {good, good};
      seen.landmarks->front().*member = odd;
      ASSERT_THAT(filter_->update({0.01, 0.0, 0.0}, seen), IsSaneEstimate()) << odd;
    }
  }
  Observations nothing, unknown = sight(truth);
  nothing.landmarks.emplace();
  unknown.landmarks->front().id = 99;
  for (const Observations& seen : {nothing, unknown}) {
    ASSERT_THAT(filter_->update({0.01, 0.0, 0.0}, seen), IsSaneEstimate());
  }
}

/// Sixteen sonars all round, which hear what a map lets expect.
Observations hear(const OccupancyGrid& map, const Pose2& T_map_base) {
  const RayCaster ray_caster(std::make_shared<const OccupancyGrid>(map));
  Observations heard;
  for (int i = 0; i < 16; ++i) {
    SonarReading reading{i, {0.0, 0.0, wrapAngle(2.0 * kPi * i / 16.0)}, 5.0, 5.0, 0.52};
    const Pose2 T_map_sonar = T_map_base * reading.T_base_sonar;
    for (double bearing = -0.26; bearing < 0.27; bearing += 0.02) {
      const Pose2 T_map_ray = T_map_sonar * Pose2{0.0, 0.0, bearing};
      reading.range = std::min(reading.range, ray_caster.range(T_map_ray, reading.max_range));
    }
    heard.sonar.push_back(reading);
  }
  return heard;
}

TEST_P(EveryFilter, ListensToSonarsWithoutAScan) {
  const auto map = asymmetricWorld();
  const Pose2 truth{3.0, 1.0, 0.5};
  const auto filter = makeFilter(GetParam(), 2000);
  filter->reset(
      Gaussian2{truth * Pose2{0.12, -0.1, 0.0}, Eigen::Vector3d(0.04, 0.04, 0.01).asDiagonal()});
  for (int i = 0; i < 12; ++i) {
    const double step = i % 2 == 0 ? 0.05 : -0.05;
    filter->update({step, 0.0, 0.0}, hear(*map, truth * Pose2{i % 2 == 0 ? 0.05 : 0.0, 0.0, 0.0}));
  }
  EXPECT_THAT(filter->estimate().T_map_base, PoseNear(truth, 0.08, 0.12));
}

TEST_P(EveryFilter, IsSaneWhateverSonarsHear) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto map = asymmetricWorld();
  const Pose2 truth{3.0, 1.0, 0.5};
  const auto filter = makeFilter(GetParam(), 2000);
  filter->reset(roughly(truth));
  const Observations good = hear(*map, truth);
  for (const double odd : {nan, inf, -inf, 0.0, -1.0, 1e-300, 1e300}) {
    for (const auto member :
         {&SonarReading::range, &SonarReading::max_range, &SonarReading::view}) {
      Observations heard = good;
      for (std::size_t i = 0; i < 8; ++i) heard.sonar[2 * i].*member = odd;
      ASSERT_THAT(filter->update({0.01, 0.0, 0.0}, heard), IsSaneEstimate()) << odd;
    }
    Observations heard = good;
    heard.sonar[3].T_base_sonar.x = odd;
    heard.sonar[5].T_base_sonar.theta = odd;
    ASSERT_THAT(filter->update({0.01, 0.0, 0.0}, heard), IsSaneEstimate()) << odd;
  }
}

TEST_P(EveryFilter, FollowsOdometryWithoutAnyObservation) {
  const auto filter = makeFilter(GetParam(), 2000);
  filter->reset(Gaussian2{{3.0, 1.0, 0.5}, Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal()});
  Pose2 expected{3.0, 1.0, 0.5};
  double before = 0.0;
  for (int i = 0; i < 10; ++i) {
    const Pose2 motion{0.1, 0.0, 0.05};
    expected = expected * motion;
    const Estimate estimate = filter->update(motion, {});
    ASSERT_THAT(estimate, IsSaneEstimate());
    if (i == 0) before = estimate.covariance.trace();
  }
  EXPECT_THAT(filter->estimate().T_map_base, PoseNear(expected, 0.1, 0.1));
  EXPECT_GT(filter->estimate().covariance.trace(), before);
}

TEST_P(EveryFilter, StartsAnewWhenTold) {
  const auto drive = toyDrive(asymmetricWorld(), 3);
  const auto filter = makeFilter(GetParam(), 1000);
  filter->reset(roughly({8.0, 3.5, 2.0}));
  for (std::size_t i = 0; i < 10; ++i) filter->update(drive[i].motion, drive[i].observations);
  filter->reset(roughly(drive[9].T_map_base));
  Estimate estimate;
  for (std::size_t i = 10; i < 25; ++i) {
    estimate = filter->update(drive[i].motion, drive[i].observations);
  }
  EXPECT_THAT(estimate.T_map_base, PoseNear(drive[24].T_map_base, 0.15, 0.087));
}

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  return std::get<0>(info.param) + "_" + std::get<1>(info.param);
}
INSTANTIATE_TEST_SUITE_P(Filters, EveryFilter,
                         testing::Combine(testing::ValuesIn(allFilters()),
                                          testing::Values("recommended", "seed")),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Filters, EveryFilterWithLandmarks,
                         testing::Combine(testing::ValuesIn(allFilters()),
                                          testing::Values("recommended", "seed")),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(MorePresets, EveryFilter, testing::Values(Case{"mcl", "fp"}), nameOf);

class GlobalLocalization : public testing::TestWithParam<const char*> {};

TEST_P(GlobalLocalization, FindsTheRobotInAWorldWithoutTwins) {
  const auto drive = toyDrive(asymmetricWorld(), 4);
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto filter = makeFilter({GetParam(), "recommended"}, 10000, seed,
                                   {{"laser_sigma_hit", 0.2}, {"effective_beams", 12.0}});
    filter->reset(Anywhere{});
    Estimate estimate;
    for (const ToyStep& step : drive) estimate = filter->update(step.motion, step.observations);
    const Pose2& truth = drive.back().T_map_base;
    if (distance(estimate.T_map_base, truth) < 0.15 &&
        std::abs(wrapAngle(estimate.T_map_base.theta - truth.theta)) < 0.087) {
      ++found;
    }
  }
  EXPECT_GE(found, 4);
}

INSTANTIATE_TEST_SUITE_P(Filters, GlobalLocalization,
                         testing::Values("kld", "amcl", "samcl", "sa_kld"));

}  // namespace
}  // namespace adaptive_localization
