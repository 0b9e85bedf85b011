// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/sonar_ring.hpp"

#include <cmath>

namespace adaptive_localization {

void SonarRing::hear(const Pose2& T_odom_base, const Observations& observations) {
  constexpr double kOld = 2.0;  // s
  for (auto kept = kept_.begin(); kept != kept_.end();) {
    const bool is_old = std::abs(observations.stamp - kept->second.stamp) > kOld;
    kept = is_old ? kept_.erase(kept) : std::next(kept);
  }
  for (const SonarReading& reading : observations.sonar) {
    kept_[reading.sonar] = {observations.stamp, T_odom_base * reading.T_base_sonar, reading};
  }
}

std::vector<SonarReading> SonarRing::readingsFrom(const Pose2& T_odom_base) const {
  std::vector<SonarReading> readings;
  for (const auto& [sonar, kept] : kept_) {
    readings.push_back(kept.reading);
    readings.back().T_base_sonar = between(T_odom_base, kept.T_odom_sonar);
  }
  return readings;
}

}  // namespace adaptive_localization
