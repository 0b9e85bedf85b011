// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/calibration.hpp"

#include <algorithm>

#include "json.hpp"

namespace adaptive_localization {

void Calibration::note(double confidence, double error_m) {
  const double place = std::min(std::max(confidence, 0.0), 1.0) * static_cast<double>(kTenths);
  const std::size_t tenth = std::min(static_cast<std::size_t>(place), kTenths - 1);
  ++scans[tenth];
  near[tenth] += error_m < kNear;
}

void Calibration::add(const Calibration& other) {
  for (std::size_t i = 0; i < kTenths; ++i) {
    scans[i] += other.scans[i];
    near[i] += other.near[i];
  }
}

std::vector<std::optional<double>> Calibration::shares() const {
  std::vector<std::optional<double>> shares(kTenths);
  for (std::size_t i = 0; i < kTenths; ++i) {
    if (scans[i] > 0) shares[i] = static_cast<double>(near[i]) / scans[i];
  }
  return shares;
}

void to_json(nlohmann::json& json, const Calibration& calibration) {
  json = {{"scans", calibration.scans}, {"near", calibration.near}};
}

void from_json(const nlohmann::json& json, Calibration& calibration) {
  json.at("scans").get_to(calibration.scans);
  json.at("near").get_to(calibration.near);
}

}  // namespace adaptive_localization
