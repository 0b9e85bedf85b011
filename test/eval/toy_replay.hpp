// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/trajectory.hpp"
#include "support/program.hpp"

namespace adaptive_localization {

constexpr double kRoomWidth = 6.0, kRoomHeight = 4.0;  // m, walls at 0 and there
constexpr int kSteps = 40;

/// Distance along one axis, moving at `speed` between walls at 0 and `width`.
inline double axisDistance(double at, double width, double speed) {
  if (speed == 0.0) return std::numeric_limits<double>::infinity();
  return speed > 0.0 ? (width - at) / speed : -at / speed;
}

/// Distance from a point in the room to the wall in a direction.
inline double wallDistance(double x, double y, double angle) {
  return std::min(axisDistance(x, kRoomWidth, std::cos(angle)),
                  axisDistance(y, kRoomHeight, std::sin(angle)));
}

inline Pose2 truthAt(int step) {
  return {1.5 + 0.05 * step, 1.2 + 0.01 * step, 0.02 * step};
}

class Replay : public testing::Test {
 protected:
  Replay() {
    map_ = saveRoom("room", 124, 84);
    log_ = folder_.write("drive.clf", driveLog());
    std::vector<StampedPose> truth;
    for (int i = 0; i < kSteps; ++i) truth.push_back({100.0 + 0.2 * i, truthAt(i)});
    truth_ = folder_.file("truth.tum");
    saveTum(truth, truth_);
  }

  /// A map of a room with walls of two cells, so many cells wide and high; gives its file.
  std::string saveRoom(const std::string& name, int width, int height) const {
    const Lattice lattice(width, height, 0.05, {-0.1, -0.1, 0.0});
    std::vector<std::int8_t> cells(lattice.size(), OccupancyGrid::kFree);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Cell cell = lattice.cell(i);
      const bool is_wall = cell.x < 2 || cell.y < 2 || cell.x > width - 3 || cell.y > height - 3;
      if (is_wall) cells[i] = OccupancyGrid::kOccupied;
    }
    saveMap(OccupancyGrid(lattice, cells), folder_.file(name));
    return folder_.file(name + ".yaml");
  }

  static std::string driveLog() {
    std::ostringstream log;
    log.precision(10);
    log << "PARAM robot_frontlaser_offset 0.0 host 0\n";
    for (int i = 0; i < kSteps; ++i) {
      const Pose2 pose = truthAt(i);
      log << "FLASER 180";
      for (int beam = 0; beam < 180; ++beam) {
        const double bearing = (beam - 90) * kPi / 180.0;
        log << ' ' << wallDistance(pose.x, pose.y, pose.theta + bearing);
      }
      const Pose2 odometry = between(truthAt(0), pose);
      for (int k = 0; k < 2; ++k) {
        log << ' ' << odometry.x << ' ' << odometry.y << ' ' << odometry.theta;
      }
      log << ' ' << 100.0 + 0.2 * i << " host 0.0\n";
    }
    return log.str();
  }

  ProgramResult replay(std::vector<std::string> more) const {
    more.insert(more.begin(), {"--map", map_, "--log", log_, "--filter", "kld"});
    return runProgram(REPLAY, more);
  }

  void expectRejected(const std::vector<std::string>& arguments, const std::string& why) const {
    const ProgramResult result = runProgram(REPLAY, arguments);
    EXPECT_EQ(result.exit_code, 1) << why;
    EXPECT_THAT(result.errors, testing::HasSubstr(why));
    EXPECT_THAT(result.output, testing::IsEmpty());
  }

  TempFolder folder_;
  std::string map_, log_, truth_;
};

}  // namespace adaptive_localization
