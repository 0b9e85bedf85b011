// SPDX-License-Identifier: BSD-3-Clause
#include "sim/laser.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace adaptive_localization {
namespace {

constexpr double kHalfSpot = 0.37 * kPi / 180.0;  // rad: the spot is 0.0129 rad wide
constexpr double kEdge = 0.3;                     // m between the two sides of an edge
constexpr double kShortest = 0.05;                // m
constexpr std::uint64_t kIntensities = 1;         // stream of randomness
constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();
constexpr float kNoReturn = std::numeric_limits<float>::infinity();

/// Whether three neighbouring ranges lie on one line seen at more than 80 degrees of incidence.
bool isGrazing(double left, double middle, double right) {
  const double steep = std::tan(80.0 * kPi / 180.0) * kHalfSpot * middle;
  return std::min(std::abs(left - middle), std::abs(middle - right)) > steep &&
         (left - middle) * (middle - right) > 0.0;
}

}  // namespace

std::vector<Pose2> laserMounts(const LaserOptions& options) {
  const Pose2 first{options.laser_x, options.laser_y, options.laser_yaw};
  if (options.lasers == 0) return {};
  if (options.lasers == 1) return {first};
  return {first, Pose2{0.0, 0.0, kPi} * first};
}

Laser::Laser(const LaserOptions& options, const Pose2& T_base_laser, Rng rng,
             const std::vector<Landmark>& landmarks)
    : options_(options),
      T_base_laser_(T_base_laser),
      rng_(rng),
      intensity_rng_(rng.split(kIntensities)),
      bias_(rng_.uniform(-options.laser_bias, options.laser_bias)) {
  std::copy_if(landmarks.begin(), landmarks.end(), std::back_inserter(reflectors_),
               [](const Landmark& landmark) { return landmark.reflector > 0.0; });
}

/// Whether the spot touches one.
bool Laser::isOnReflector(const Pose2& T_map_ray, double range) const {
  const Eigen::Vector2d end = T_map_ray * Eigen::Vector2d(range, 0.0);
  return std::any_of(reflectors_.begin(), reflectors_.end(), [&](const Landmark& reflector) {
    return (reflector.place - end).norm() < reflector.reflector / 2.0 + kHalfSpot * range;
  });
}

float Laser::intensity(const Beam& beam) {
  constexpr double kReflector = 200.0, kOther = 40.0, kMost = 255.0;
  if (!std::isfinite(beam.range)) return 0.0F;
  const bool is_bright = beam.is_on_reflector || intensity_rng_.uniform() < options_.laser_glare;
  const double exact = is_bright ? kReflector : kOther;
  const double read = exact + intensity_rng_.normal(0.0, options_.laser_intensity_noise);
  return static_cast<float>(std::clamp(std::nearbyint(read), 0.0, kMost));
}

Laser::Beam Laser::measure(const Pose2& T_map_ray, const Caster& cast) {
  const double limit = options_.laser_max_range;
  const double middle = cast(T_map_ray, limit);
  const double left = cast(T_map_ray * Pose2{0.0, 0.0, kHalfSpot}, limit);
  const double right = cast(T_map_ray * Pose2{0.0, 0.0, -kHalfSpot}, limit);

  double range = middle;
  if (rng_.uniform() < options_.laser_dazzle) return {kInvalid};
  if (rng_.uniform() < options_.laser_short) {
    range = rng_.uniform(kShortest, std::max(range, kShortest));
  } else if (isGrazing(left, middle, right)) {
    if (rng_.uniform() < options_.laser_grazing) return {kInvalid};
  } else if (std::abs(left - right) > kEdge && rng_.uniform() < options_.laser_mixed) {
    range = rng_.uniform(std::min(left, right), std::max(left, right));
  }
  if (range >= limit) return {kNoReturn};

  const bool is_on_reflector = range == middle && isOnReflector(T_map_ray, middle);
  range += bias_ + rng_.normal(0.0, options_.laser_noise);
  if (options_.laser_resolution > 0.0) {
    range = std::nearbyint(range / options_.laser_resolution) * options_.laser_resolution;
  }
  return {static_cast<float>(std::max(range, 0.0)), is_on_reflector};
}

LaserScan Laser::scan(const Pose2& T_map_base, const Caster& cast, const Velocity& velocity) {
  constexpr double kTurnsPerSecond = 75.0;
  const double degree = kPi / 180.0;
  LaserScan scan;
  const double view = kPi * (options_.laser_view / 180.0);
  scan.angle_min = -view / 2.0;
  int beams = options_.laser_beams;
  scan.angle_increment = view / (beams - 1);
  if (options_.laser_interlaced) {
    beams = second_half_ ? 180 : 181;
    scan.angle_min = second_half_ ? -89.5 * degree : -90.0 * degree;
    scan.angle_increment = degree;
    second_half_ = !second_half_;
  }
  scan.time_increment = scan.angle_increment / (2.0 * kPi) / kTurnsPerSecond;
  scan.range_max = options_.laser_max_range * 1.0125;  // 81 and 8.1, as the driver says

  scan.ranges.reserve(static_cast<std::size_t>(beams));
  for (int i = 0; i < beams; ++i) {
    const double bearing = scan.angle_min + i * scan.angle_increment;
    const Pose2 T_map_laser = T_map_base * arc(velocity, i * scan.time_increment) * mount();
    const Beam beam = measure(T_map_laser * Pose2{0.0, 0.0, bearing}, cast);
    scan.ranges.push_back(beam.range);
    if (!reflectors_.empty()) scan.intensities.push_back(intensity(beam));
  }
  return scan;
}

}  // namespace adaptive_localization
