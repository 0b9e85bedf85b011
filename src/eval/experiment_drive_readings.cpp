// SPDX-License-Identifier: BSD-3-Clause
// What a laser reads that is carried or occluded, or before which something stands, what a compass
// does, and what sonars hear.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiment_drive.hpp"

namespace adaptive_localization {

/// A hand, or anything.
LaserScan ExperimentDrive::handBefore(LaserScan scan, bool is_garbage) {
  std::fill(scan.intensities.begin(), scan.intensities.end(), 0.0F);
  for (float& range : scan.ranges) {
    const double any = rng_.uniform();
    range = static_cast<float>(rng_.uniform(0.05, 0.4));
    if (!is_garbage) continue;
    range = static_cast<float>(rng_.uniform(0.05, 8.0));
    if (any < 0.1) range = std::numeric_limits<float>::infinity();
    if (any > 0.9) range = std::numeric_limits<float>::quiet_NaN();
  }
  return scan;
}

LaserScan ExperimentDrive::carriedReadings() {
  LaserScan scan = last_scan_;
  scan.stamp = time();
  return handBefore(std::move(scan), carry_->is_garbage);
}

void ExperimentDrive::hear(const ImuReading& reading) {
  headings_.addHeading(time(), reading.heading);
  headings_.addRate(time(), reading.rate, reading.rate_deviation);
}

/// A gyroscope turns with the robot that is carried.
void ExperimentDrive::carryGyroscope() {
  const auto turn = headings_.turnAt(time());
  if (!turn) return;
  const double rate = carry_->turn / (carry_->until - carry_->from);
  headings_.addRate(std::nextafter(time(), time() + 1.0), rate, turn->deviation);
}

bool ExperimentDrive::isOn(const Due& due, ExperimentEvent::What what) const {
  const double now = time() + Simulation::kStep / 2.0;
  return due.event.what == what && now >= due.at && now < due.at + due.event.duration;
}

double ExperimentDrive::compassError() const {
  double error = 0.0;
  for (const auto& due : due_) {
    if (isOn(due, ExperimentEvent::What::kDisturb)) error += due.event.turned_by;
  }
  return error;
}

void ExperimentDrive::hear(const Ping& ping) {
  pings_.emplace_back(T_odom_wheels_ * simulation_.odometry().T_odom_base, ping);
}

/// From base at a pose.
std::vector<SonarReading> ExperimentDrive::heardBefore(const Pose2& T_odom_base) {
  std::vector<SonarReading> readings;
  for (const auto& [T_odom_then, ping] : std::exchange(pings_, {})) {
    readings.push_back(simulation_.reading(ping));
    SonarReading& reading = readings.back();
    reading.T_base_sonar = between(T_odom_base, T_odom_then) * reading.T_base_sonar;
  }
  return readings;
}

/// What stands before a beam is nearer than what the beam would have met.
LaserScan ExperimentDrive::blocked(LaserScan scan) {
  const double count = static_cast<double>(scan.ranges.size());
  for (const auto& due : due_) {
    if (isOn(due, ExperimentEvent::What::kCover)) return handBefore(std::move(scan), false);
    if (!isOn(due, ExperimentEvent::What::kBlock)) continue;
    const double first = due.first_bearing * (1.0 - due.event.share);
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double place = (static_cast<double>(i) + 0.5) / count - first;
      const bool is_hit = due.event.is_sector ? place >= 0.0 && place < due.event.share
                                              : rng_.uniform() < due.event.share;
      if (!is_hit) continue;
      const double limit = std::isfinite(scan.ranges[i]) ? scan.ranges[i] : 4.0;
      scan.ranges[i] =
          static_cast<float>(limit * rng_.uniform(due.event.is_sector ? 0.4 : 0.05, 0.9));
      if (!scan.intensities.empty()) scan.intensities[i] = 0.0F;
    }
  }
  return scan;
}

}  // namespace adaptive_localization
