// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kRangeNoise = 0.02;  // m, beside its share of the range
constexpr double kOnWall = 0.1;       // m, a landmark so far in a wall is on it

Eigen::Vector2d fromBase(const Pose2& T_map_base, const Eigen::Vector2d& place) {
  return inverse(T_map_base) * place;
}

}  // namespace

bool Camera::isInView(const Pose2& T_map_base, const Eigen::Vector2d& place,
                      const Caster& cast) const {
  const Eigen::Vector2d point = fromBase(T_map_base, place);
  const double bearing = std::atan2(point.y(), point.x());
  if (point.norm() > options_.camera_max_range) return false;
  if (std::abs(bearing) > options_.camera_view / 2.0) return false;
  const Pose2 T_map_ray = T_map_base * Pose2{0.0, 0.0, bearing};
  return cast(T_map_ray, point.norm()) >= point.norm() - kOnWall;
}

Sighting Camera::measured(int id, double range, double bearing) {
  Sighting sighting;
  sighting.id = options_.camera_identifies ? id : -1;
  sighting.range_deviation = options_.camera_range_noise * range + kRangeNoise;
  sighting.bearing_deviation = options_.camera_bearing_noise;
  sighting.range = std::max(0.0, range + rng_.normal(0.0, sighting.range_deviation));
  sighting.bearing = wrapAngle(bearing + rng_.normal(0.0, sighting.bearing_deviation));
  return sighting;
}

/// Of a landmark's look, anywhere in the view.
Sighting Camera::falseOne() {
  const auto which =
      static_cast<std::size_t>(rng_.uniform() * static_cast<double>(landmarks_.size()));
  const double range = rng_.uniform(0.3, options_.camera_max_range);
  const double bearing = rng_.uniform(-0.5, 0.5) * options_.camera_view;
  return measured(landmarks_[std::min(which, landmarks_.size() - 1)].id, range, bearing);
}

std::vector<Sighting> Camera::sight(const Pose2& T_map_base, const Caster& cast) {
  const double false_per_true = options_.camera_false_share / (1.0 - options_.camera_false_share);
  std::vector<Sighting> sightings;
  for (const Landmark& landmark : landmarks_) {
    if (!isInView(T_map_base, landmark.place, cast)) continue;
    if (rng_.uniform() < options_.camera_miss_share) continue;
    const Eigen::Vector2d point = fromBase(T_map_base, landmark.place);
    sightings.push_back(measured(landmark.id, point.norm(), std::atan2(point.y(), point.x())));
    if (rng_.uniform() < false_per_true) sightings.push_back(falseOne());
  }
  return sightings;
}

}  // namespace adaptive_localization
