// SPDX-License-Identifier: BSD-3-Clause
#include "ser/place_refiner.hpp"

#include <gmock/gmock.h>

#include <memory>
#include <vector>

#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kTruth{2.0, 3.0, -0.5};

/// A refiner of a scan that was taken at kTruth.
struct Scene {
  std::shared_ptr<const OccupancyGrid> map = asymmetricWorld();
  std::shared_ptr<const DistanceField> field = std::make_shared<const DistanceField>(*map);
  Observations seen = ToyLaser{181, -kPi / 2, kPi / 2, 12.0}.observe(map, kTruth);
  PlaceRefiner refiner{map, field, seen.scan, seen.scan.max_range, RangeError::kTruncation};
};

/// Poses about the truth, a step of a pattern search or two away.
std::vector<Pose2> starts() {
  std::vector<Pose2> all;
  for (const double x : {-0.09, 0.06}) {
    for (const double y : {-0.07, 0.08}) {
      for (const double theta : {-0.05, 0.04}) all.push_back(kTruth * Pose2{x, y, theta});
    }
  }
  return all;
}

TEST(PlaceRefiner, MovesAPoseToWhereTheScanFits) {
  const Scene scene;
  for (const Pose2& start : starts()) {
    for (const Place& place : {scene.refiner.refine(start), scene.refiner.align(start)}) {
      EXPECT_THAT(place.T_map_base, PoseNear(kTruth, 0.02, 0.01));
      EXPECT_DOUBLE_EQ(place.error, scene.refiner.error(place.T_map_base));
      EXPECT_LT(place.error, 0.5 * scene.refiner.error(start));
    }
  }
}

TEST(PlaceRefiner, ApproachesSuchAPlaceToSomeCentimetres) {
  const Scene scene;
  const double far = scene.refiner.approach(kTruth * Pose2{1.0, 0.5, 0.8}).error;
  for (const Pose2& start : starts()) {
    const Place place = scene.refiner.approach(start);
    EXPECT_THAT(place.T_map_base, PoseNear(kTruth, 0.05, 0.03));
    EXPECT_LT(place.error, 0.5 * far) << "by which places are told apart";
  }
}

}  // namespace
}  // namespace adaptive_localization
