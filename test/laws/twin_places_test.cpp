// SPDX-License-Identifier: BSD-3-Clause
// Two rooms of an office look the same. Whatever odometry got wrong, it got wrong in both: no scan
// tells one from the other because a core knows where it is in one of them.
#include <gtest/gtest.h>

#include "adaptive_localization/map/map_io.hpp"
#include "localizer/hypotheses.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr double kUsual = 0.02;  // m

double massNear(const Hypotheses& hypotheses, const Pose2& pose) {
  for (const Mode& mode : hypotheses.modes()) {
    if (distance(mode.T_map_base, pose) < 0.1) return mode.mass;
  }
  return 0.0;
}

TEST(TwinPlaces, AreJudgedAlikeWhateverOdometryGotWrong) {
  const auto office =
      std::make_shared<const OccupancyGrid>(loadMap(SOURCE_DIR "/maps/office/map.yaml"));
  const Pose2 core{16.44, 12.64, 0.73};
  const Pose2 twin{20.44, 12.64, 0.73};
  const auto seen = ToyLaser{181, -kPi / 2, kPi / 2, 30.0}.observe(office, twin);
  for (const double x : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
    for (const double y : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
      for (const double turn : {-0.3, -0.1, -0.05, 0.05, 0.1, 0.3}) {
        const Pose2 slip{x, y, turn};
        Hypotheses hypotheses(office);
        hypotheses.add(core * slip, 0.0);
        hypotheses.add(twin * slip, 0.0);
        hypotheses.note(core);
        hypotheses.weigh(seen, News{}, kUsual);
        EXPECT_NEAR(massNear(hypotheses, core), 0.5, 0.01) << x << ", " << y << ", " << turn;
        EXPECT_NEAR(massNear(hypotheses, twin), 0.5, 0.01) << x << ", " << y << ", " << turn;
      }
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
