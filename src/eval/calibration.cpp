// SPDX-License-Identifier: BSD-3-Clause
#include "eval/calibration.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace adaptive_localization {

void Calibration::note(double confidence, double error_m) {
  const double place = std::min(std::max(confidence, 0.0), 1.0) * static_cast<double>(kTenths);
  const std::size_t tenth = std::min(static_cast<std::size_t>(place), kTenths - 1);
  ++scans[tenth];
  near[tenth] += error_m < kNear;
}

void to_json(nlohmann::json& json, const Calibration& calibration) {
  json = {{"scans", calibration.scans}, {"near", calibration.near}};
}

}  // namespace adaptive_localization
