// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace adaptive_localization {
namespace {

double openField(const Pose2&, double max_range) {
  return max_range;
}

double wallAtTwoMetres(const Pose2&, double max_range) {
  return std::min(2.0, max_range);
}

class ACamera : public testing::Test {
 protected:
  std::vector<Sighting> sight(int pictures, const Camera::Caster& cast = openField) {
    Camera camera(options_, {{4, {3.0, 0.0}}, {5, {-3.0, 0.0}}, {6, {50.0, 0.0}}}, Rng(3));
    std::vector<Sighting> all;
    for (int i = 0; i < pictures; ++i) {
      for (const Sighting& sighting : camera.sight({}, cast)) all.push_back(sighting);
    }
    return all;
  }

  CameraOptions options_;
};

TEST_F(ACamera, SightsWhatIsBeforeItAndNotTooFar) {
  options_.camera_miss_share = 0.0;
  const auto sightings = sight(1000);
  ASSERT_EQ(sightings.size(), 1000U);
  double range = 0.0, squares = 0.0, turns = 0.0;
  for (const Sighting& sighting : sightings) {
    EXPECT_EQ(sighting.id, 4);
    range += sighting.range / 1000.0;
    squares += std::pow(sighting.range - 3.0, 2) / 1000.0;
    turns += std::pow(sighting.bearing, 2) / 1000.0;
    EXPECT_NEAR(sighting.range_deviation, 0.32, 1e-9);
  }
  EXPECT_NEAR(range, 3.0, 0.04);
  EXPECT_NEAR(std::sqrt(squares), 0.32, 0.03);
  EXPECT_NEAR(std::sqrt(turns), 0.05, 0.005);
}

TEST_F(ACamera, SightsAllRoundIfItsViewIsSo) {
  options_.camera_miss_share = 0.0;
  options_.camera_view = 2.0 * kPi;
  EXPECT_EQ(sight(10).size(), 20U);
}

TEST_F(ACamera, MissesAShare) {
  options_.camera_miss_share = 0.3;
  EXPECT_NEAR(static_cast<double>(sight(2000).size()), 1400.0, 80.0);
}

TEST_F(ACamera, HasAShareOfFalseSightings) {
  options_.camera_miss_share = 0.0;
  options_.camera_false_share = 0.2;
  EXPECT_NEAR(static_cast<double>(sight(2000).size()), 2500.0, 80.0);
}

TEST_F(ACamera, DoesNotSeeThroughWalls) {
  EXPECT_TRUE(sight(10, wallAtTwoMetres).empty());
}

TEST_F(ACamera, MayNotIdentify) {
  options_.camera_identifies = false;
  for (const Sighting& sighting : sight(10)) EXPECT_EQ(sighting.id, -1);
}

}  // namespace
}  // namespace adaptive_localization
