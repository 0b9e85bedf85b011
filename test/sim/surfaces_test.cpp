// SPDX-License-Identifier: BSD-3-Clause
// The surfaces of a plan are what a laser sees in its world.
#include <gmock/gmock.h>

#include <algorithm>

#include "adaptive_localization/core/rng.hpp"
#include "sim/free_space.hpp"
#include "test_worlds.hpp"

namespace adaptive_localization {
namespace {

class SurfacesOf : public testing::TestWithParam<std::string> {};

TEST_P(SurfacesOf, RaysEndOnThemWhereTheyEndInTheWorld) {
  const FloorPlan plan = loadFloorPlan(worldFile(GetParam()));
  const auto world = makeWorld(plan, false);
  const FreeSpace space(world, 0.1);
  const std::vector<Segment> surfaces = surfacesOf(plan);
  Rng rng(6);
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector2d place = space.sample(rng);
    const double theta = rng.uniform(-kPi, kPi);
    const Eigen::Vector2d direction(std::cos(theta), std::sin(theta));
    double range = 80.0;
    Segment met = surfaces.front();
    for (const auto& surface : surfaces) {
      const double at = hit(surface, place, direction);
      if (at < range) {
        range = at;
        met = surface;
      }
    }
    ASSERT_NEAR(range, world->range({place.x(), place.y(), theta}, 80.0), 2e-5) << "ray " << i;
    const Eigen::Vector2d along = met.b - met.a;
    ASSERT_LT(direction.x() * -along.y() + direction.y() * along.x(), 0.0)
        << "ray " << i << " meets a surface from behind";
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, SurfacesOf, testing::ValuesIn(kWorlds),
                         [](const auto& world) { return world.param; });

}  // namespace
}  // namespace adaptive_localization
