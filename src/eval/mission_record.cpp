// SPDX-License-Identifier: BSD-3-Clause
#include "mission_record.hpp"

#include <cmath>

namespace adaptive_localization {

void MissionRecord::observe(const Simulation& simulation, bool has_scan) {
  const RouteFollower& driver = simulation.driver();
  const Eigen::Vector2d place(simulation.truth().x, simulation.truth().y);
  if (driver.reached() > static_cast<int>(arrival_errors_.size())) {
    arrival_errors_.push_back((driver.lastReached() - place).norm());
  }
  const double off = driver.distanceFromWay(place);
  if (!has_scan || !std::isfinite(off)) return;
  squares_ += off * off;
  ++scans_;
}

double MissionRecord::wayError() const {
  return scans_ == 0 ? 0.0 : std::sqrt(squares_ / scans_);
}

}  // namespace adaptive_localization
