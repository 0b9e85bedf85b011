// SPDX-License-Identifier: BSD-3-Clause
#include "ser/place_sampler.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

/// Draws of a sampler, sorted by whether they are around a pose.
struct Draws {
  int around{0};
  int elsewhere{0};
  double variance_x{0.0}, variance_theta{0.0};  // of those around, about the pose
};

class PlaceSamplerTest : public testing::Test {
 protected:
  void use(const std::shared_ptr<const OccupancyGrid>& map, double ser_share) {
    PlaceSamplerOptions options;
    options.place_ser_share = ser_share;
    map_ = map;
    places_ = std::make_shared<Places>(map, std::make_shared<const DistanceField>(*map),
                                       EnergyGridOptions{}, GlobalSearchOptions{});
    sampler_ = std::make_unique<PlaceSampler>(options, places_, map);
  }

  Draws draw(int count, const Pose2& pose) {
    Draws draws;
    for (int i = 0; i < count; ++i) {
      const Pose2 drawn = sampler_->draw(rng_);
      const double turned = wrapAngle(drawn.theta - pose.theta);
      const bool is_around = distance(drawn, pose) < 0.6 && std::abs(turned) < 0.35;
      ++(is_around ? draws.around : draws.elsewhere);
      if (!is_around) continue;
      draws.variance_x += (drawn.x - pose.x) * (drawn.x - pose.x);
      draws.variance_theta += turned * turned;
    }
    draws.variance_x /= draws.around;
    draws.variance_theta /= draws.around;
    return draws;
  }

  std::shared_ptr<const OccupancyGrid> map_;
  std::shared_ptr<Places> places_;
  std::unique_ptr<PlaceSampler> sampler_;
  Rng rng_{1};
};

TEST_F(PlaceSamplerTest, DrawsAroundTheOnePlaceWhereTheScanFits) {
  const Pose2 truth{2.53, 3.51, 0.4};
  use(asymmetricWorld(), 0.0);
  ASSERT_TRUE(sampler_->condition(ToyLaser{181}.observe(map_, truth)));
  const Draws draws = draw(5000, truth);
  EXPECT_GT(draws.around, 4900);
  EXPECT_NEAR(std::sqrt(draws.variance_x), 0.1, 0.02);
  EXPECT_NEAR(std::sqrt(draws.variance_theta), kPi / 60.0, 0.01);
}

TEST_F(PlaceSamplerTest, LeavesAShareToTheSer) {
  const Pose2 truth{2.53, 3.51, 0.4};
  use(asymmetricWorld(), 0.2);
  ASSERT_TRUE(sampler_->condition(ToyLaser{181}.observe(map_, truth)));
  EXPECT_NEAR(draw(5000, truth).elsewhere, 1000, 130);
}

TEST_F(PlaceSamplerTest, DrawsAroundBothOfTwins) {
  const Pose2 truth{2.3, 0.8, 0.4};
  const Pose2 twin{6.0 - truth.x, 3.0 - truth.y, wrapAngle(truth.theta + kPi)};
  use(symmetricWorld(), 0.0);
  ASSERT_TRUE(sampler_->condition(ToyLaser{181}.observe(map_, truth)));
  const int here = draw(5000, truth).around;
  const int there = draw(5000, twin).around;
  EXPECT_GT(here + there, 4800);
  EXPECT_GT(here, 1000);
  EXPECT_GT(there, 1000);
}

TEST_F(PlaceSamplerTest, ForgetsThePlacesOfTheScanBefore) {
  const Pose2 first{2.53, 3.51, 0.4}, second{1.0, 1.0, 0.3};
  use(asymmetricWorld(), 0.0);
  for (const Pose2& truth : {first, second, first}) {
    ASSERT_TRUE(sampler_->condition(ToyLaser{181}.observe(map_, truth)));
    EXPECT_GT(draw(500, truth).around, 450);
  }
  EXPECT_FALSE(sampler_->condition(Observations{}));
  EXPECT_GT(draw(500, first).elsewhere, 400);  // all free space
}

}  // namespace
}  // namespace adaptive_localization
