// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>

namespace adaptive_localization {

/// How often estimates were near the truth, by tenths of the confidence that was said with them: a
/// confidence that means what it says is the share of them.
struct Calibration {
  static constexpr std::size_t kTenths = 10;
  static constexpr double kNear = 0.3;  // m

  void note(double confidence, double error_m);

  std::array<int, kTenths> scans{};  // by confidence, [0, 0.1) first
  std::array<int, kTenths> near{};   // of these, those with an error below kNear
};

/// By this name the JSON library finds it.
void to_json(nlohmann::json& json, const Calibration& calibration);

}  // namespace adaptive_localization
