// SPDX-License-Identifier: BSD-3-Clause
#include "observation/landmark_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "map/landmark_file.hpp"

namespace adaptive_localization {
namespace {

constexpr double kMostDeviations = 6.0;  // of a sighting, beyond which it is of something else
constexpr double kMetresEach = 0.05;     // what a deviation counts for in misfit(), m
constexpr double kSighted = 3.0;         // deviations, within which a landmark counts as sighted
constexpr std::size_t kMostRing = 96;    // poses that explain a single sighting

/// Range and bearing of a place from a pose.
struct Polar {
  double range, bearing;
};

Polar seenFrom(const Pose2& T_map_base, const Eigen::Vector2d& place) {
  const double dx = place.x() - T_map_base.x, dy = place.y() - T_map_base.y;
  return {std::hypot(dx, dy), wrapAngle(std::atan2(dy, dx) - T_map_base.theta)};
}

/// In standard deviations, of range and bearing.
double deviations(const Sighting& sighting, const Polar& expected) {
  return std::hypot((sighting.range - expected.range) / sighting.range_deviation,
                    wrapAngle(sighting.bearing - expected.bearing) / sighting.bearing_deviation);
}

Eigen::Vector2d pointOf(const Sighting& sighting) {
  return sighting.range * Eigen::Vector2d(std::cos(sighting.bearing), std::sin(sighting.bearing));
}

/// Sources refuse what makes no sense; whoever calls a core may not.
bool isUsable(const Sighting& sighting) {
  return std::isfinite(sighting.range) && std::isfinite(sighting.bearing) &&
         sighting.range >= 0.0 && sighting.range_deviation > 0.0 &&
         sighting.bearing_deviation > 0.0;
}

/// The candidate that looks most like the sighting's from a pose.
const Eigen::Vector2d& nearest(const Sighting& sighting, const Pose2& T_map_base,
                               const std::vector<Eigen::Vector2d>& candidates) {
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                             return deviations(sighting, seenFrom(T_map_base, a)) <
                                    deviations(sighting, seenFrom(T_map_base, b));
                           });
}

}  // namespace

LandmarkMap knownLandmarks(const LandmarkOptions& options) {
  if (options.landmark_map.empty()) return {};
  try {
    return loadLandmarks(options.landmark_map);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("option 'landmark_map': " + std::string(error.what()));
  }
}

LandmarkModel::LandmarkModel(const LandmarkOptions& options,
                             std::shared_ptr<const OccupancyGrid> map,
                             std::shared_ptr<const DistanceField> field)
    : LandmarkModel(options, knownLandmarks(options), std::move(map), std::move(field)) {}

LandmarkModel::LandmarkModel(const LandmarkOptions& options, LandmarkMap landmarks,
                             std::shared_ptr<const OccupancyGrid> map,
                             std::shared_ptr<const DistanceField> field)
    : options_(options),
      landmarks_(std::move(landmarks)),
      map_(map),
      ray_caster_(std::move(map), std::move(field)) {}

/// Those that may be of a known landmark.
std::vector<Sighting> LandmarkModel::sightingsIn(const Observations& observations) const {
  std::vector<Sighting> usable;
  if (!observations.landmarks) return usable;
  for (const Sighting& sighting : *observations.landmarks) {
    const bool is_known = !landmarks_.candidates(sighting.id).empty();
    if (is_known && isUsable(sighting)) usable.push_back(sighting);
  }
  return usable;
}

bool LandmarkModel::canLocalize(const Observations& observations) const {
  return !sightingsIn(observations).empty();
}

double LandmarkModel::likelihood(const Sighting& sighting, const Pose2& T_map_base,
                                 const std::vector<Eigen::Vector2d>& candidates) const {
  const bool is_exponential = options_.landmark_likelihood == "exponential";
  double sum = 0.0, most = 0.0, nearest = 0.0, least_off = 1e9;
  for (const Eigen::Vector2d& place : candidates) {
    const Polar expected = seenFrom(T_map_base, place);
    const double off = std::abs(sighting.range - expected.range);
    const double turn = wrapAngle(sighting.bearing - expected.bearing);
    const double d = deviations(sighting, expected);
    const double value =
        is_exponential ? std::exp(-0.5 * (off + std::abs(turn))) : std::exp(-0.5 * d * d);
    sum += value;
    most = std::max(most, value);
    if (off < least_off) nearest = value;
    least_off = std::min(least_off, off);
  }
  if (options_.landmark_association == "nearest") return most;
  if (options_.landmark_association == "nearest_distance") return nearest;
  return candidates.empty() ? 0.0 : sum / static_cast<double>(candidates.size());
}

/// Of the landmarks that should be sighted from a pose.
double LandmarkModel::logOfMisses(const std::vector<Sighting>& sightings,
                                  const Pose2& T_map_base) const {
  constexpr double kEdge = 0.9;  // of range and view; at their ends nothing is certain
  constexpr double kWall = 0.3;  // m, a landmark on a wall is not behind it
  double sum = 0.0;
  for (const Landmark& landmark : landmarks_.all()) {
    const Polar expected = seenFrom(T_map_base, landmark.place);
    if (expected.range > kEdge * options_.landmark_max_range) continue;
    if (std::abs(expected.bearing) > kEdge * options_.landmark_view / 2.0) continue;
    const bool is_sighted =
        std::any_of(sightings.begin(), sightings.end(), [&](const Sighting& sighting) {
          const bool may_be = sighting.id < 0 || sighting.id == landmark.id;
          return may_be && deviations(sighting, expected) < kSighted;
        });
    if (is_sighted) continue;
    const Pose2 T_map_ray = T_map_base * Pose2{0.0, 0.0, expected.bearing};
    if (ray_caster_.range(T_map_ray, expected.range) < expected.range - kWall) continue;
    sum += std::log(std::max(options_.landmark_miss_share, 1e-3));
  }
  return sum;
}

double LandmarkModel::score(const Observations& observations, const Particles& particles,
                            Eigen::Ref<Eigen::ArrayXd> log_likelihood) const {
  if (!observations.landmarks || landmarks_.all().empty()) return 0.0;
  const double f = options_.landmark_false_share;
  const std::vector<Sighting> sightings = sightingsIn(observations);
  for (const Sighting& sighting : sightings) {
    const auto candidates = landmarks_.candidates(sighting.id);
    for (Eigen::Index i = 0; i < particles.size(); ++i) {
      const double m = likelihood(sighting, particles.pose(i), candidates);
      log_likelihood[i] += std::log(std::max((1.0 - f) * m + f, 1e-12));
    }
  }
  if (options_.landmark_max_range > 0.0) {
    for (Eigen::Index i = 0; i < particles.size(); ++i) {
      log_likelihood[i] += logOfMisses(sightings, particles.pose(i));
    }
  }
  return static_cast<double>(sightings.size());
}

std::vector<PoseObservation> LandmarkModel::linearized(const Observations& observations,
                                                       const Pose2& T_map_base) const {
  constexpr double kTooNear = 0.05;  // m, where bearings tell nothing
  std::vector<PoseObservation> all;
  for (const Sighting& sighting : sightingsIn(observations)) {
    const auto candidates = landmarks_.candidates(sighting.id);
    const Eigen::Vector2d& place = nearest(sighting, T_map_base, candidates);
    const Polar expected = seenFrom(T_map_base, place);
    if (expected.range < kTooNear) continue;
    const double c = (place.x() - T_map_base.x) / expected.range;
    const double s = (place.y() - T_map_base.y) / expected.range;
    PoseObservation seen;
    seen.innovation = Eigen::Vector2d(sighting.range - expected.range,
                                      wrapAngle(sighting.bearing - expected.bearing));
    seen.H.resize(2, 3);
    seen.H << -c, -s, 0.0, s / expected.range, -c / expected.range, -1.0;
    seen.R = Eigen::Vector2d(sighting.range_deviation * sighting.range_deviation,
                             sighting.bearing_deviation * sighting.bearing_deviation)
                 .asDiagonal();
    all.push_back(seen);
  }
  return all;
}

std::optional<double> LandmarkModel::misfit(const Observations& observations,
                                            const Pose2& T_map_base) const {
  const std::vector<Sighting> sightings = sightingsIn(observations);
  if (sightings.empty()) return std::nullopt;
  double sum = 0.0;
  for (const Sighting& sighting : sightings) {
    const auto candidates = landmarks_.candidates(sighting.id);
    const Polar expected = seenFrom(T_map_base, nearest(sighting, T_map_base, candidates));
    sum += kMetresEach * std::min(deviations(sighting, expected), kMostDeviations);
  }
  return sum / static_cast<double>(sightings.size());
}

bool LandmarkModel::isFree(const Eigen::Vector2d& place) const {
  return map_->isFree(map_->lattice().cellAt(place));
}

/// Poses from which one sighting looks as it does: on a circle round each candidate.
void LandmarkModel::addRing(const Sighting& sighting, std::vector<Pose2>& poses) const {
  const auto candidates = landmarks_.candidates(sighting.id);
  const auto each = std::max<std::size_t>(4, kMostRing / candidates.size());
  for (const Eigen::Vector2d& place : candidates) {
    for (std::size_t k = 0; k < each; ++k) {
      const double course = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(each);
      const Eigen::Vector2d at =
          place - sighting.range * Eigen::Vector2d(std::cos(course), std::sin(course));
      if (isFree(at)) poses.push_back({at.x(), at.y(), wrapAngle(course - sighting.bearing)});
    }
  }
}

/// Poses from which two sightings are of two landmarks: both lie as far from one another.
void LandmarkModel::addPair(const Sighting& a, const Sighting& b, std::vector<Pose2>& poses) const {
  const Eigen::Vector2d in_base = pointOf(b) - pointOf(a);
  const double deviation = std::hypot(a.range_deviation, b.range_deviation) +
                           std::hypot(a.range * a.bearing_deviation, b.range * b.bearing_deviation);
  for (const Eigen::Vector2d& place_a : landmarks_.candidates(a.id)) {
    for (const Eigen::Vector2d& place_b : landmarks_.candidates(b.id)) {
      const Eigen::Vector2d in_map = place_b - place_a;
      if (in_map.isZero() || std::abs(in_map.norm() - in_base.norm()) > 3.0 * deviation) continue;
      const double theta =
          wrapAngle(std::atan2(in_map.y(), in_map.x()) - std::atan2(in_base.y(), in_base.x()));
      const Eigen::Vector2d middle =
          0.5 * (place_a + place_b) -
          Pose2{0.0, 0.0, theta} * Eigen::Vector2d(0.5 * (pointOf(a) + pointOf(b)));
      if (isFree(middle)) poses.push_back({middle.x(), middle.y(), theta});
    }
  }
}

std::vector<Pose2> LandmarkModel::explanations(const Observations& observations,
                                               bool are_samples_asked) const {
  std::vector<Pose2> poses;
  const std::vector<Sighting> sightings = sightingsIn(observations);
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    for (std::size_t j = i + 1; j < sightings.size(); ++j) {
      addPair(sightings[i], sightings[j], poses);
    }
  }
  if (poses.empty() && are_samples_asked) {
    for (const Sighting& sighting : sightings) addRing(sighting, poses);
  }
  return poses;
}

}  // namespace adaptive_localization
