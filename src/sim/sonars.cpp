// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sonars.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kShareOfRange = 0.01;  // standard deviation
constexpr int kRays = 15;               // in a cone

/// Where a ray ends, and by how much the surface there is turned away from it, rad; positive if its
/// right side is nearer.
struct Hit {
  double range, turned_by;
};

/// By the rays beside it: on a plane, tan(angle) = dr / (r dbearing).
std::optional<Hit> hitOf(const Pose2& T_map_ray, double limit, const Sonars::Caster& cast) {
  constexpr double kBeside = 0.25 * kDegree;
  const auto range = [&](double bearing) {
    return cast(T_map_ray * Pose2{0.0, 0.0, bearing}, limit);
  };
  const double right = range(-kBeside), middle = range(0.0), left = range(kBeside);
  if (middle >= limit) return std::nullopt;
  const double to_left = (left - middle) / kBeside, to_right = (middle - right) / kBeside;
  const double slope = std::abs(to_left) < std::abs(to_right) ? to_left : to_right;
  return Hit{middle, std::atan(slope / std::max(middle, 1e-3))};
}

}  // namespace

const std::array<Pose2, Sonars::kCount>& Sonars::mounts() {
  static const std::array<Pose2, kCount> all = [] {
    constexpr std::array<std::array<double, 3>, kCount> kPlaces{{
        {69, 136, 90},
        {114, 119, 50},
        {148, 78, 30},
        {166, 27, 10},
        {166, -27, -10},
        {148, -78, -30},
        {114, -119, -50},
        {69, -136, -90},
        {-157, -136, -90},
        {-203, -119, -130},
        {-237, -78, -150},
        {-255, -27, -170},
        {-255, 27, 170},
        {-237, 78, 150},
        {-203, 119, 130},
        {-157, 136, 90},
    }};  // mm, degrees
    std::array<Pose2, kCount> poses;
    for (std::size_t i = 0; i < kCount; ++i) {
      poses[i] = {kPlaces[i][0] / 1e3, kPlaces[i][1] / 1e3, kPlaces[i][2] * kDegree};
    }
    return poses;
  }();
  return all;
}

std::vector<Ping> Sonars::ping(double stamp, const Pose2& T_map_base, const Caster& cast) {
  constexpr std::size_t kSide = kCount / 2;
  std::vector<Ping> pings;
  for (const std::size_t sonar : {next_, next_ + kSide}) {
    pings.push_back({stamp, sonar, listen(T_map_base * mounts()[sonar], cast)});
  }
  next_ = (next_ + 1) % kSide;
  return pings;
}

/// The way of a ray to an echo: of a surface that faces it, of one behind a mirror, or of a corner
/// of two mirrors, which send it back to where it came from.
std::optional<double> Sonars::echo(const Pose2& T_map_ray, double limit, const Caster& cast) const {
  constexpr double kOff = 0.02;            // m, before a mirror
  constexpr double kBack = 5.0 * kDegree;  // off the way back, at the most,
  constexpr double kEar = 0.1;             // m, and past the sonar
  const double mirror = options_.sonar_mirror_angle;
  const auto first = hitOf(T_map_ray, limit, cast);
  if (!first) return std::nullopt;
  if (std::abs(first->turned_by) < mirror) return first->range;
  const Pose2 T_map_first =
      T_map_ray * Pose2{first->range - kOff, 0.0, kPi - 2.0 * first->turned_by};
  const auto second = hitOf(T_map_first, limit - first->range, cast);
  if (!second) return std::nullopt;
  if (std::abs(second->turned_by) < mirror) return first->range + second->range;
  const Pose2 T_map_second = T_map_first * Pose2{second->range, 0.0, kPi - 2.0 * second->turned_by};
  const Pose2 back = between(T_map_ray, T_map_second);
  const bool is_heard = std::abs(wrapAngle(back.theta - kPi)) < kBack && std::abs(back.y) < kEar;
  if (!is_heard) return std::nullopt;
  return (first->range + second->range + distance(T_map_second, T_map_ray)) / 2.0;
}

double Sonars::listen(const Pose2& T_map_sonar, const Caster& cast) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double view = options_.sonar_view;
  double range = kNone;
  for (int i = 0; i < kRays; ++i) {
    const double bearing = (static_cast<double>(i) / (kRays - 1) - 0.5) * view;
    const auto way = echo(T_map_sonar * Pose2{0.0, 0.0, bearing}, options_.sonar_max_range, cast);
    range = std::min(range, way.value_or(kNone));
  }
  const double noise = rng_.normal(0.0, 1.0);
  const double foreign = rng_.uniform() * options_.sonar_max_range;
  const bool is_foreign_heard = rng_.uniform() < options_.sonar_cross_talk;
  if (std::isfinite(range)) {
    range += noise * (options_.sonar_noise + kShareOfRange * range);
  }
  if (is_foreign_heard) range = std::min(range, foreign);
  return range < options_.sonar_max_range ? std::max(range, options_.sonar_min_range) : kNone;
}

SonarReading Sonars::reading(const Ping& ping) const {
  SonarReading reading;
  reading.sonar = static_cast<int>(ping.sonar);
  reading.T_base_sonar = mounts()[ping.sonar];
  reading.range = ping.range;
  reading.max_range = options_.sonar_max_range;
  reading.view = options_.sonar_view;
  return reading;
}

}  // namespace adaptive_localization
