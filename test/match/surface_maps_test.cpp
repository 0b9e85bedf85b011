// SPDX-License-Identifier: BSD-3-Clause
#include "match/surface_maps.hpp"

#include <gtest/gtest.h>

#include "support/thick_room.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

TEST(SurfaceMaps, AreTheSameForAllAsLongAsSomebodyHasThem) {
  const auto map = asymmetricWorld();
  SurfaceMaps surfaces(map, MapQuality(*map));
  auto one = surfaces.faces(1.0);
  EXPECT_EQ(surfaces.faces(1.0), one);
  const auto farther = surfaces.faces(2.0);
  EXPECT_NE(farther, one);
  EXPECT_EQ(farther->surfaces().size(), one->surfaces().size());
  const std::weak_ptr<const SurfaceMap> watched = one;
  one.reset();
  EXPECT_TRUE(watched.expired());
}

TEST(SurfaceMaps, OfMiddlesAreThereWhereWallsAreThick) {
  const auto thin = roomWithWalls(0, 1);
  EXPECT_EQ(SurfaceMaps(thin, MapQuality(*thin)).middles(1.0), nullptr);
  const auto thick = roomWithWalls(0, 7);
  SurfaceMaps surfaces(thick, MapQuality(*thick));
  const auto middles = surfaces.middles(1.0);
  ASSERT_NE(middles, nullptr);
  EXPECT_EQ(surfaces.middles(1.0), middles);
  EXPECT_NE(surfaces.faces(1.0), middles);
}

}  // namespace
}  // namespace adaptive_localization
