// SPDX-License-Identifier: BSD-3-Clause
#include "thick_walls_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "map/thin_walls.hpp"

namespace adaptive_localization {
namespace {

constexpr auto kForm = LikelihoodField::Form::kTempered;
constexpr double kFaceHits = 0.06;  // m, deviation of hits from the faces of painted walls

std::shared_ptr<const DistanceField> fieldOf(const OccupancyGrid& map) {
  return std::make_shared<const DistanceField>(map);
}

ObservationOptions withSigma(ObservationOptions options, double sigma_hit) {
  if (options.laser_sigma_hit == 0.0) options.laser_sigma_hit = sigma_hit;
  return options;
}

/// So that about a hundred of them are looked at.
Eigen::Index strideOf(Eigen::Index count) {
  return 1 + (count - 1) / 100;
}

/// Sum of the distances of hits from walls, m, none counting as more than 0.15 m.
double offWalls(const Pose2& pose, const Scan& scan, const DistanceField& walls) {
  constexpr double kFar = 0.15;  // m
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < scan.x.size(); i += strideOf(scan.x.size())) {
    const auto x = static_cast<double>(scan.x[i]), y = static_cast<double>(scan.y[i]);
    sum +=
        std::min(kFar, walls.at(Eigen::Vector2d(pose.x + c * x - s * y, pose.y + s * x + c * y)));
  }
  return sum;
}

/// That of some particles that fits best.
Pose2 bestOf(const Particles& particles, const Scan& scan, const DistanceField& walls) {
  Pose2 best;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < particles.size(); i += strideOf(particles.size())) {
    const double off = offWalls(particles.pose(i), scan, walls);
    if (off >= least) continue;
    least = off;
    best = particles.pose(i);
  }
  return best;
}

}  // namespace

ThickWallsField::ThickWallsField(const ObservationOptions& options,
                                 std::shared_ptr<const OccupancyGrid> map,
                                 std::shared_ptr<const DistanceField> field)
    : ray_caster_(map, field),
      walls_(field),
      by_walls_(options, kForm, field),
      by_faces_(withSigma(options, kFaceHits), kForm, fieldOf(withHollowWalls(*map))),
      by_middles_(withSigma(options, field->quality().middleDeviation()), kForm,
                  fieldOf(withThinWalls(*map, field->quality().wallDepth()))) {}

const LikelihoodField& ThickWallsField::field() const {
  constexpr double kClear = 1.0;  // a lead that counts
  const double lead = vote_.leadOfMiddles();
  return lead > kClear ? by_middles_ : lead < -kClear ? by_faces_ : by_walls_;
}

/// Where in the walls the hits are: -1 at the faces, 1 in the middles, 0 half way between. Beams to
/// both sides make up for a pose that slid to one of them. In rock every hit is at its face.
double ThickWallsField::evidenceFrom(const Scan& scan, const Particles& particles) const {
  constexpr double kReach = 2.0;  // m: the longest way of a beam through a wall
  constexpr int kThin = 2;        // cells, from the first to the last: too few to tell
  constexpr int kLeast = 10;      // beams
  const double thick = (kThin + 0.5) * walls_->lattice().resolution();
  const Pose2 pose = bestOf(particles, scan, *walls_);
  const Eigen::Vector2d sensor = pose * scan.position;
  double sum = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < scan.range.size(); i += strideOf(scan.range.size())) {
    const Pose2 ray{sensor.x(), sensor.y(), wrapAngle(pose.theta + scan.bearing[i])};
    const RayCaster::Wall wall = ray_caster_.wall(ray, scan.max_range, kReach);
    const double depth = wall.far - wall.near;
    if (depth < thick) continue;
    const double share = (scan.range[i] - wall.near) / depth;
    if (share < -0.5 || share > 1.5) continue;  // not of this wall
    sum += share;
    ++count;
  }
  return count < kLeast ? 0.0 : 4.0 * (sum / count - 0.25);
}

double ThickWallsField::score(const Observations& observations, const Particles& particles,
                              Eigen::Ref<Eigen::ArrayXd> log_likelihood) const {
  if (observations.scan.hits() > 0 && particles.size() > 0) {
    vote_.add(evidenceFrom(observations.scan, particles));
  }
  return field().score(observations, particles, log_likelihood);
}

}  // namespace adaptive_localization
