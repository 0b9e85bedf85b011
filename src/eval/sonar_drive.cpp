// SPDX-License-Identifier: BSD-3-Clause
#include "eval/sonar_drive.hpp"

#include <cmath>
#include <stdexcept>

namespace adaptive_localization {

SonarDrive driveSonars(const SimulationOptions& options, double seconds, Poses poses,
                       const std::function<void(std::size_t)>& progress) {
  if (!options.sonars.sonars) {
    throw std::invalid_argument("option 'sonars': got false, expected true to map with them");
  }
  SimulationOptions driven = options;
  driven.drive = true;
  Simulation simulation = Simulation::load(driven);
  const Pose2 T_map_odom = simulation.truth() * inverse(simulation.odometry().T_odom_base);
  const auto pose = [&] {
    return poses == Poses::kTruth ? simulation.truth()
                                  : T_map_odom * simulation.odometry().T_odom_base;
  };
  SonarDrive drive;
  const auto steps = std::lround(seconds / Simulation::kStep);
  for (long step = 1; step <= steps; ++step) {
    const Sensed sensed = simulation.step();
    for (const Ping& ping : sensed.pings) {
      drive.readings.push_back({pose(), simulation.reading(ping)});
    }
    constexpr long kTenth = 10;  // steps
    if (step % kTenth != 0) continue;
    drive.path.push_back(pose());
    if (progress) progress(static_cast<std::size_t>(step / kTenth));
  }
  return drive;
}

SonarDrive driveOf(const Log& log, Poses poses) {
  SonarDrive drive;
  bool is_sonar_heard = false;
  for (const LogScan& scan : log.scans) {
    is_sonar_heard = is_sonar_heard || !scan.sonar.empty();
    const std::optional<Pose2> pose =
        poses == Poses::kTruth ? scan.T_map_base : std::optional<Pose2>(scan.T_odom_base);
    if (!pose) continue;
    drive.path.push_back(*pose);
    for (const SonarReading& reading : scan.sonar) drive.readings.push_back({*pose, reading});
  }
  if (!is_sonar_heard) {
    throw std::invalid_argument("no readings of sonars; sonar_topics:=TOPIC names their topics");
  }
  if (drive.readings.empty()) {
    throw std::invalid_argument("no reading of a sonar when there are poses to place it by");
  }
  return drive;
}

}  // namespace adaptive_localization
