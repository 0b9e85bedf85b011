// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a robot where places look the same.
#include <gtest/gtest.h>

#include "adaptive_localization/localizer/localizer.hpp"
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

/// Two rooms of an office look the same. Whatever odometry got wrong, it got wrong in both: no scan
/// tells one from the other because a core knows where it is in one of them.
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

/// A corner of the maze looks like others, and while that is compared the robot is carried away:
/// where it was did not give way to another place by what scans said, and the place where it is now
/// is proven as soon as for a robot that was tracked.
TEST(LikeCorners, LoseACarriedRobotNoLongerWhileTheyAreCompared) {
  const auto maze =
      std::make_shared<const OccupancyGrid>(loadMap(SOURCE_DIR "/maps/maze/map.yaml"));
  const ToyLaser laser{181, -kPi / 2, kPi / 2, 8.0};
  const Pose2 start{0.8, 1.0, 1.57}, corner{5.5, 2.7, 0.0}, there{2.6, 0.5, 1.0};
  Parameters parameters;
  parameters.set("filter", std::string("sa_kld"));
  Localizer localizer(parameters, maze);
  localizer.reset(Gaussian2{start, Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal()});
  Pose2 T_odom_base;
  const auto see = [&](const Pose2& T_map_base) {
    localizer.requestUpdate();
    return localizer.update(T_odom_base, laser.observe(maze, T_map_base));
  };
  for (int i = 0; i < 10; ++i) see(start);
  const Pose2 step{0.0, 0.0, 0.02};
  int tracked = 0;
  Status status = Status::kLost;
  for (Pose2 at = corner; at.theta < 1.0; at = at * step) {
    status = see(at).status;
    tracked += status == Status::kTracking ? 1 : 0;
    T_odom_base = T_odom_base * step;
  }
  ASSERT_GT(tracked, 10) << "before more was in sight that other corners show as well";
  ASSERT_EQ(status, Status::kAmbiguous);
  int scans = 0;
  double off = 0.0;
  for (status = Status::kLost; status != Status::kTracking && scans < 20; ++scans) {
    const Localization answer = see(there);
    status = answer.status;
    off = distance(answer.T_map_base, there);
  }
  EXPECT_LE(scans, 4);
  EXPECT_LT(off, 0.1);
}

}  // namespace
}  // namespace adaptive_localization
