// SPDX-License-Identifier: BSD-3-Clause
#include "observation/sonar_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"
#include "sonar_reading.hpp"

namespace adaptive_localization {
namespace {

constexpr int kRays = 7;                 // across a cone
constexpr double kFacedEcho = 0.9;       // probability of an echo of a wall that is faced,
constexpr double kObliqueEcho = 0.3;     // and of one that is not
constexpr double kMostDeviations = 4.0;  // of an echo, beyond which it is of something else
constexpr double kMetresEach = 0.05;     // what a deviation counts for in misfit(), m
constexpr std::size_t kLeastEchoes = 4;  // that localize

std::vector<SonarReading> usableIn(const Observations& observations) {
  std::vector<SonarReading> usable;
  std::copy_if(observations.sonar.begin(), observations.sonar.end(), std::back_inserter(usable),
               isUsable);
  return usable;
}

std::vector<SonarReading> echoesIn(const Observations& observations) {
  std::vector<SonarReading> echoes = usableIn(observations);
  echoes.erase(std::remove_if(echoes.begin(), echoes.end(),
                              [](const SonarReading& reading) { return !isEcho(reading); }),
               echoes.end());
  return echoes;
}

}  // namespace

SonarModel::SonarModel(const SonarOptions& options, std::shared_ptr<const OccupancyGrid> map,
                       std::shared_ptr<const DistanceField> field)
    : options_(options),
      resolution_(map->lattice().resolution()),
      ray_caster_(std::move(map), std::move(field)) {}

/// Rays from side to side. A wall that is faced is about as near within the cone as anywhere in it;
/// in a grid of cells, by a cell.
SonarModel::Wall SonarModel::nearestWall(const SonarReading& reading, const Pose2& T_map_base,
                                         double limit) const {
  const Pose2 T_map_sonar = T_map_base * reading.T_base_sonar;
  std::array<double, kRays> ranges{};
  Wall wall{limit, 0.0, false};
  for (int i = 0; i < kRays; ++i) {
    const double bearing = (static_cast<double>(i) / (kRays - 1) - 0.5) * reading.view;
    const double range = ray_caster_.range(T_map_sonar * Pose2{0.0, 0.0, bearing}, limit);
    ranges[static_cast<std::size_t>(i)] = range;
    if (range < wall.range) wall = {range, bearing, false};
  }
  const double within = *std::min_element(ranges.begin() + 1, ranges.end() - 1);
  wall.is_faced = within < limit && within < wall.range + resolution_;
  return wall;
}

double SonarModel::deviation(const SonarReading& reading) const {
  return options_.sonar_sigma + shareOfRange(isEcho(reading) ? reading.range : 0.0);
}

double SonarModel::likelihood(const SonarReading& reading, const Pose2& T_map_base) const {
  const double f = options_.sonar_false_share;
  const double s = deviation(reading);
  const double reach = isEcho(reading) ? reading.range + kMostDeviations * s : reading.max_range;
  const Wall wall = nearestWall(reading, T_map_base, std::min(reach, reading.max_range));
  const bool is_wall = wall.range < std::min(reach, reading.max_range);
  const double echo = !is_wall ? 0.0 : wall.is_faced ? kFacedEcho : kObliqueEcho;
  if (!isEcho(reading)) return f + (1.0 - f) * (1.0 - echo);
  const double off = (reading.range - wall.range) / s;
  return f + (1.0 - f) * echo * std::exp(-0.5 * off * off);
}

double SonarModel::score(const Observations& observations, const Particles& particles,
                         Eigen::Ref<Eigen::ArrayXd> log_likelihood) const {
  constexpr std::size_t kChunk = 64;
  const std::vector<SonarReading> readings = usableIn(observations);
  if (readings.empty()) return 0.0;
  const auto count = static_cast<double>(readings.size());
  const double independent = std::min(count, options_.effective_sonars);
  const double weight = independent / count;
  parallelFor(static_cast<std::size_t>(particles.size()), kChunk, [&](const Chunk& chunk) {
    for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      double sum = 0.0;
      for (const SonarReading& reading : readings) {
        sum += std::log(likelihood(reading, particles.pose(i)));
      }
      log_likelihood[i] += weight * sum;
    }
  });
  return independent;
}

std::vector<PoseObservation> SonarModel::linearized(const Observations& observations,
                                                    const Pose2& T_map_base) const {
  const std::vector<SonarReading> echoes = echoesIn(observations);
  const double tempering =
      std::max(1.0, static_cast<double>(echoes.size()) / options_.effective_sonars);
  std::vector<PoseObservation> all;
  for (const SonarReading& reading : echoes) {
    const double s = deviation(reading);
    const Wall wall = nearestWall(reading, T_map_base, reading.max_range);
    if (!wall.is_faced || std::abs(reading.range - wall.range) > kMostDeviations * s) continue;
    const Pose2 T_map_sonar = T_map_base * reading.T_base_sonar;
    const double course = T_map_sonar.theta + wall.bearing;
    const Eigen::Vector2d towards(std::cos(course), std::sin(course));
    const Eigen::Vector2d arm(T_map_sonar.x - T_map_base.x, T_map_sonar.y - T_map_base.y);
    PoseObservation seen;
    seen.innovation.setConstant(1, reading.range - wall.range);
    seen.H.resize(1, 3);
    seen.H << -towards.x(), -towards.y(), arm.y() * towards.x() - arm.x() * towards.y();
    seen.R.setConstant(1, 1, tempering * s * s);
    all.push_back(seen);
  }
  return all;
}

bool SonarModel::canLocalize(const Observations& observations) const {
  return echoesIn(observations).size() >= kLeastEchoes;
}

std::optional<double> SonarModel::misfit(const Observations& observations,
                                         const Pose2& T_map_base) const {
  const std::vector<SonarReading> echoes = echoesIn(observations);
  if (echoes.size() < kLeastEchoes) return std::nullopt;
  std::vector<double> off;
  for (const SonarReading& reading : echoes) {
    const double s = deviation(reading);
    const Wall wall = nearestWall(reading, T_map_base, reading.range + kMostDeviations * s);
    off.push_back(std::min(std::abs(reading.range - wall.range) / s, kMostDeviations));
  }
  std::sort(off.begin(), off.end());
  off.resize(off.size() - off.size() / 4);
  double sum = 0.0;
  for (const double deviations : off) sum += deviations;
  return kMetresEach * sum / static_cast<double>(off.size());
}

}  // namespace adaptive_localization
