// SPDX-License-Identifier: BSD-3-Clause
#include "eval/sonar_profiles.hpp"

#include <cmath>

#include "map/evidence_models.hpp"

namespace adaptive_localization {
namespace {

constexpr double kDegree = kPi / 180.0;

/// A cell's probability after one reading, by its distance, m, and its bearing from the axis, rad.
class OneReading {
 public:
  OneReading(std::string model, const EvidenceOptions& options, const SonarReading& sonar,
             double resolution)
      : model_(std::move(model)), options_(options), sonar_(sonar), resolution_(resolution) {
    options_.evidence_reach = sonar.max_range;  // long ones too
  }

  /// On a lattice that has the middle of a cell just there, on the x axis, and all of the cone.
  double probability(double range, double distance, double bearing) const {
    const int half = static_cast<int>(std::ceil(1.1 * sonar_.max_range / resolution_)) + 1;
    const double corner = -(half + 0.5) * resolution_;
    const Lattice lattice(2 * half + 1, 2 * half + 1, resolution_,
                          {distance + corner, corner, 0.0});
    const auto grid = makeEvidenceGrid(model_, lattice, options_);
    SonarReading reading = sonar_;
    reading.T_base_sonar = {};
    reading.range = range;
    grid->add({0.0, 0.0, -bearing}, reading);
    return grid->probability({half, half});
  }

 private:
  std::string model_;
  EvidenceOptions options_;
  SonarReading sonar_;
  double resolution_;
};

/// Pairs of where and how probable, from low to high.
template <class Probability>
nlohmann::json curve(double low, double high, double step, const Probability& probability) {
  nlohmann::json points = nlohmann::json::array();
  for (double at = low; at <= high; at += step) points.push_back({at, probability(at)});
  return points;
}

}  // namespace

nlohmann::json sonarProfiles(const std::vector<std::string>& models, const EvidenceOptions& options,
                             const SonarReading& sonar, double resolution) {
  const double side = 5.0 * std::ceil(0.5 * sonar.view / kDegree / 5.0 + 0.5);  // degrees
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& model : models) {
    const OneReading one(model, options, sonar, resolution);
    for (int range = 1; range < sonar.max_range && range <= 5; ++range) {
      const auto across = [&](double distance) {
        return curve(-side, side, 0.5, [&](double bearing) {
          return one.probability(range, distance, bearing * kDegree);
        });
      };
      const auto along = curve(0.01, sonar.max_range, 0.01, [&](double distance) {
        return one.probability(range, distance, 0.0);
      });
      rows.push_back({{"model", model},
                      {"range", range},
                      {"along", along},
                      {"arc", across(range)},
                      {"half_way", across(0.5 * range)}});
    }
  }
  return {{"kind", "sonar_profiles"}, {"profiles", rows}};
}

}  // namespace adaptive_localization
