// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "eval/log.hpp"
#include "sim/simulation.hpp"

namespace adaptive_localization {

/// A reading of a sonar with the pose that the map is to be made by.
struct PlacedReading {
  Pose2 T_map_base;
  SonarReading reading;
};

/// What sonars heard on a drive.
struct SonarDrive {
  std::vector<PlacedReading> readings;
  std::vector<Pose2> path;  // T_map_base
};

/// Which poses a map is made by.
enum class Poses { kTruth, kOdometry };

/// Drives a simulated robot for so many seconds. By odometry, the drive starts at the true pose.
/// Calls `progress` with the tenths of a second that are done. Throws std::invalid_argument naming
/// the option that does not fit, also when the robot has no sonars.
SonarDrive driveSonars(const SimulationOptions& options, double seconds, Poses poses,
                       const std::function<void(std::size_t)>& progress = {});

/// The same of a recording. By truth, readings without a reference are left out. Throws
/// std::invalid_argument if nothing is left.
SonarDrive driveOf(const Log& log, Poses poses);

}  // namespace adaptive_localization
