// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sim/simulation.hpp"

namespace adaptive_localization {

/// How well a driver who steers by the estimate drives, on the floor.
class MissionRecord {
 public:
  /// After each step of the simulation.
  void observe(const Simulation& simulation, bool has_scan);

  /// How far the robot was from each way-point that its driver took for reached, m.
  const std::vector<double>& arrivalErrors() const { return arrival_errors_; }
  /// How far it was from the way that its driver followed, rms over all scans, m.
  double wayError() const;

 private:
  std::vector<double> arrival_errors_;
  double squares_{0.0};  // m^2
  int scans_{0};
};

}  // namespace adaptive_localization
