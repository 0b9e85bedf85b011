// SPDX-License-Identifier: BSD-3-Clause
#include "ser/ser_sampler.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kTruth{2.525, 3.525, 0.0};

class SerSamplerTest : public testing::Test {
 protected:
  std::shared_ptr<const OccupancyGrid> map_ = asymmetricWorld();
  std::shared_ptr<Places> places_ =
      std::make_shared<Places>(map_, std::make_shared<const DistanceField>(*map_),
                               EnergyGridOptions{}, GlobalSearchOptions{});
  SerSampler sampler_{places_, map_};
  Rng rng_{1};

  static Observations seenFrom(const Pose2& pose) {
    return ToyLaser{181}.observe(asymmetricWorld(), pose);
  }

  double widestX(int draws) {
    double low = 1e9, high = -1e9;
    for (int i = 0; i < draws; ++i) {
      const Pose2 pose = sampler_.draw(rng_);
      low = std::min(low, pose.x);
      high = std::max(high, pose.x);
    }
    return high - low;
  }
};

TEST_F(SerSamplerTest, DrawsPosesOfSimilarEnergy) {
  const Observations seen = seenFrom(kTruth);
  ASSERT_TRUE(sampler_.condition(seen));
  const auto grid = places_->energyGrid(seen.scan);
  const double energy = grid->energyOf(seen.scan)->value;
  double sum = 0.0;
  int near = 0;
  constexpr int kDraws = 300;
  for (int i = 0; i < kDraws; ++i) {
    const Pose2 pose = sampler_.draw(rng_);
    const Scan there = seenFrom(pose).scan;
    const double off = std::abs(grid->energyOf(there)->value - energy);
    sum += off;
    near += off < 0.05 ? 1 : 0;  // 0.02, and half a cell and half a heading step beside
  }
  EXPECT_LT(sum / kDraws, 0.025);
  EXPECT_GT(near, 0.9 * kDraws);
}

TEST_F(SerSamplerTest, DrawsAroundTheTruthToo) {
  ASSERT_TRUE(sampler_.condition(seenFrom(kTruth)));
  int near = 0;
  for (int i = 0; i < 200000; ++i) {
    const Pose2 pose = sampler_.draw(rng_);
    const bool in_cell =
        std::abs(pose.x - kTruth.x) <= 0.025 && std::abs(pose.y - kTruth.y) <= 0.025;
    near += in_cell && std::abs(pose.theta) <= kPi / 18.0 ? 1 : 0;
  }
  EXPECT_GT(near, 0);
}

TEST_F(SerSamplerTest, DrawsUniformlyFromAllOfTheRegion) {
  const Observations seen = seenFrom(kTruth);
  ASSERT_TRUE(sampler_.condition(seen));
  const auto grid = places_->energyGrid(seen.scan);
  const auto region = grid->similarTo(*grid->energyOf(seen.scan));
  double x = 0.0, cosine = 0.0;
  for (std::size_t i = region.begin; i < region.end; ++i) {
    x += grid->pose(i).x;
    cosine += std::cos(grid->pose(i).theta);
  }
  const auto size = static_cast<double>(region.size());
  double drawn_x = 0.0, drawn_cosine = 0.0;
  constexpr int kDraws = 50000;
  for (int i = 0; i < kDraws; ++i) {
    const Pose2 pose = sampler_.draw(rng_);
    drawn_x += pose.x / kDraws;
    drawn_cosine += std::cos(pose.theta) / kDraws;
  }
  EXPECT_NEAR(drawn_x, x / size, 0.05);  // four standard errors
  EXPECT_NEAR(drawn_cosine, cosine / size, 0.02);
}

TEST_F(SerSamplerTest, DrawsFromFreeSpaceWhereItKnowsNothing) {
  EXPECT_GT(widestX(500), 8.5);
  ASSERT_TRUE(sampler_.condition(seenFrom(kTruth)));
  EXPECT_FALSE(sampler_.isEmpty());
  EXPECT_FALSE(sampler_.condition(Observations{}));
  EXPECT_TRUE(sampler_.isEmpty());
  EXPECT_GT(widestX(500), 8.5);
}

TEST_F(SerSamplerTest, SaysThatNoPlaceHasSuchAnEnergy) {
  Observations wide = seenFrom(kTruth);  // no wall of this world is that far all round
  wide.scan.view.range.setConstant(9.9F);
  EXPECT_FALSE(sampler_.condition(wide));
  EXPECT_TRUE(sampler_.isEmpty());
  EXPECT_GT(widestX(500), 8.5);
}

TEST_F(SerSamplerTest, OutlivesRangesThatAreNoNumbers) {
  Observations odd = seenFrom(kTruth);
  odd.scan.range.setConstant(std::numeric_limits<float>::quiet_NaN());
  sampler_.condition(odd);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(isFinite(sampler_.draw(rng_)));
}

TEST(SerSampler, WaitsForAGridThatIsBeingMade) {
  const auto map = asymmetricWorld();
  const auto places = std::make_shared<Places>(map, std::make_shared<const DistanceField>(*map),
                                               EnergyGridOptions{}, GlobalSearchOptions{},
                                               Places::Build::kInBackground);
  SerSampler sampler(places, map);
  Rng rng(1);
  const Observations seen = ToyLaser{181}.observe(map, kTruth);
  EXPECT_FALSE(sampler.condition(seen));
  EXPECT_TRUE(isFinite(sampler.draw(rng)));
  bool knows = false;
  for (int i = 0; i < 1000 && !knows; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    knows = sampler.condition(seen);
  }
  EXPECT_TRUE(knows);
}

}  // namespace
}  // namespace adaptive_localization
