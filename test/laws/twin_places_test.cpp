// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a robot where places look the same.
#include <gtest/gtest.h>

#include <cmath>

#include "adaptive_localization/core/rng.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "adaptive_localization/map/map_io.hpp"
#include "localizer/hypotheses.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

constexpr double kUsual = 0.02;  // m

Parameters saKld() {
  Parameters parameters;
  parameters.set("filter", std::string("sa_kld"));
  return parameters;
}

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
  Localizer localizer(saKld(), maze);
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

/// One of two passages that look much alike, in one of which the robot was tracked. After three
/// seconds of a garbled laser it is put down in the other: scans that hardly contradict where it
/// was do not make it tracked there before the other is searched for.
TEST(LikePassages, AreNotTakenForEachOtherAfterAGarbledLaser) {
  const auto map =
      std::make_shared<const OccupancyGrid>(loadMap(SOURCE_DIR "/maps/expansion/map.yaml"));
  const ToyLaser laser{181, -kPi / 2, kPi / 2, 8.0};
  const Pose2 start{4.95, 4.31, -0.51};
  Rng rng(1);
  const auto garbled = [&] {
    Observations seen = laser.observe(map, start);
    Scan& scan = seen.scan;
    for (Eigen::Index i = 0; i < scan.range.size(); ++i) {
      scan.range[i] = static_cast<float>(rng.uniform(0.1, 8.0));
      scan.x[i] = scan.range[i] * std::cos(scan.bearing[i]);
      scan.y[i] = scan.range[i] * std::sin(scan.bearing[i]);
    }
    return seen;
  };
  const auto isFound = [&](const Pose2& there) {
    Localizer localizer(saKld(), map);
    localizer.reset(Gaussian2{start, Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal()});
    const auto see = [&](const Observations& seen) {
      localizer.requestUpdate();
      return localizer.update({}, seen);
    };
    for (int i = 0; i < 10; ++i) see(laser.observe(map, start));
    for (int i = 0; i < 30; ++i) see(garbled());
    Localization answer;
    for (int i = 0; i < 30; ++i) {
      answer = see(laser.observe(map, there));
      EXPECT_TRUE(answer.status != Status::kTracking || distance(answer.T_map_base, there) < 0.5)
          << there.x << ", " << there.y << ", " << there.theta << ", scan " << i;
    }
    return answer.status == Status::kTracking;
  };
  int found = 0;
  for (const double x : {5.0, 5.2, 5.4, 5.6}) {
    for (const double y : {0.6, 0.7, 0.8}) {
      for (const double heading : {-0.3, -0.1, 0.1}) found += isFound({x, y, heading}) ? 1 : 0;
    }
  }
  EXPECT_GE(found, 15) << "of 36; a robot that stands still cannot tell the others";
}

/// All that is in sight in a corner could also be things that were brought to where the robot was:
/// but they came at once, and the corner has them all.
TEST(LikeCorners, AreLeftForTheCornerWhereACarriedRobotIs) {
  const auto maze =
      std::make_shared<const OccupancyGrid>(loadMap(SOURCE_DIR "/maps/maze/map.yaml"));
  const ToyLaser laser{181, -kPi / 2, kPi / 2, 8.0};
  const Pose2 corner{5.5, 2.7, 0.0};
  for (const double x : {3.2, 3.6, 4.0, 4.4}) {
    Localizer localizer(saKld(), maze);
    const Pose2 start{x, 2.7, 0.0};
    localizer.reset(Gaussian2{start, Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal()});
    const auto see = [&](const Pose2& T_map_base) {
      localizer.requestUpdate();
      return localizer.update({}, laser.observe(maze, T_map_base));
    };
    Localization answer;
    for (int i = 0; i < 10; ++i) answer = see(start);
    ASSERT_EQ(answer.status, Status::kTracking);
    for (int i = 0; i < 5; ++i) answer = see(corner);
    EXPECT_EQ(answer.status, Status::kTracking) << x;
    EXPECT_LT(distance(answer.T_map_base, corner), 0.1) << x;
  }
}

/// A cart that is pushed near at once, say: no other place has it.
TEST(LikeCorners, AreNotLeftForWhatOnlyStandsInTheWay) {
  const auto maze =
      std::make_shared<const OccupancyGrid>(loadMap(SOURCE_DIR "/maps/maze/map.yaml"));
  const ToyLaser laser{181, -kPi / 2, kPi / 2, 8.0};
  for (const double x : {3.2, 3.6, 4.0, 4.4}) {
    for (const float far : {0.4F, 0.8F, 1.2F}) {
      Localizer localizer(saKld(), maze);
      const Pose2 start{x, 2.7, 0.0};
      localizer.reset(Gaussian2{start, Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal()});
      Observations seen = laser.observe(maze, start);
      const auto see = [&] {
        localizer.requestUpdate();
        return localizer.update({}, seen);
      };
      for (int i = 0; i < 10; ++i) see();
      Scan& scan = seen.scan;
      for (Eigen::Index i = 0; i < scan.range.size(); ++i) {  // its side, from 10 to 90 degrees
        const float range = far / std::cos(scan.bearing[i] - 0.87F);
        if (scan.bearing[i] < 0.17F || range > scan.range[i]) continue;
        scan.range[i] = range;
        scan.x[i] = range * std::cos(scan.bearing[i]);
        scan.y[i] = range * std::sin(scan.bearing[i]);
      }
      for (int i = 0; i < 30; ++i) {
        EXPECT_LT(distance(see().T_map_base, start), 0.2) << x << ", " << far << ", scan " << i;
      }
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
