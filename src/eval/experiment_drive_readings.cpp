// SPDX-License-Identifier: BSD-3-Clause
// What a laser reads that is carried, or before which something stands, and what a compass does.
#include <cmath>
#include <limits>

#include "experiment_drive.hpp"

namespace adaptive_localization {

LaserScan ExperimentDrive::carriedReadings() {
  LaserScan scan = last_scan_;
  scan.stamp = time();
  for (float& range : scan.ranges) {
    const double any = rng_.uniform();
    range = static_cast<float>(rng_.uniform(0.05, 0.4));
    if (!carry_->is_garbage) continue;
    range = static_cast<float>(rng_.uniform(0.05, 8.0));
    if (any < 0.1) range = std::numeric_limits<float>::infinity();
    if (any > 0.9) range = std::numeric_limits<float>::quiet_NaN();
  }
  return scan;
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

double ExperimentDrive::compassError() const {
  double error = 0.0;
  for (const auto& due : due_) {
    const bool is_on = due.event.what == ExperimentEvent::What::kDisturb &&
                       time() >= due.at - Simulation::kStep / 2.0 &&
                       time() < due.at + due.event.duration - Simulation::kStep / 2.0;
    if (is_on) error += due.event.turned_by;
  }
  return error;
}

/// What stands before a beam is nearer than what the beam would have met.
LaserScan ExperimentDrive::blocked(LaserScan scan) {
  const double count = static_cast<double>(scan.ranges.size());
  for (const auto& due : due_) {
    if (due.event.what != ExperimentEvent::What::kBlock) continue;
    if (time() < due.at || time() >= due.at + due.event.duration) continue;
    const double first = due.first_bearing * (1.0 - due.event.share);
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double place = (static_cast<double>(i) + 0.5) / count - first;
      const bool is_hit = due.event.is_sector ? place >= 0.0 && place < due.event.share
                                              : rng_.uniform() < due.event.share;
      if (!is_hit) continue;
      const double limit = std::isfinite(scan.ranges[i]) ? scan.ranges[i] : 4.0;
      scan.ranges[i] =
          static_cast<float>(limit * rng_.uniform(due.event.is_sector ? 0.4 : 0.05, 0.9));
    }
  }
  return scan;
}

}  // namespace adaptive_localization
