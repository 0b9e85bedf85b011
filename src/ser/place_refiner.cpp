// SPDX-License-Identifier: BSD-3-Clause
#include "place_refiner.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr Eigen::Index kBeams = 90;        // looked at, of a scan that has more
constexpr double kLeastStep = 0.005;       // m: steps are halved down to this for a place that was
constexpr double kLeastStepHere = 0.0015;  // m: searched, and for one that is followed

Eigen::Index strideFor(Eigen::Index beams) {
  return std::max<Eigen::Index>(1, beams / kBeams);
}

}  // namespace

PlaceRefiner::PlaceRefiner(std::shared_ptr<const OccupancyGrid> map,
                           std::shared_ptr<const DistanceField> field, const Scan& scan,
                           double max_range, double truncation)
    : range_error_(std::move(map), field, truncation),
      field_(std::move(field)),
      scan_(scan),
      max_range_(max_range),
      truncation_(truncation) {}

double PlaceRefiner::misfit(const Pose2& T_map_base) const {
  return field_->sumBetween(T_map_base, scan_.x, scan_.y, strideFor(scan_.x.size()), truncation_);
}

double PlaceRefiner::hitShare(const Pose2& T_map_base, double distance) const {
  if (scan_.hits() == 0) return 0.0;
  const Transform2 to_map(T_map_base);
  int near = 0;
  for (Eigen::Index i = 0; i < scan_.x.size(); ++i) {
    near += field_->at(to_map * Eigen::Vector2d(scan_.x[i], scan_.y[i])) < distance ? 1 : 0;
  }
  return static_cast<double>(near) / scan_.hits();
}

Place PlaceRefiner::refine(const Pose2& T_map_base, double stiffness) const {
  const auto cost = [&](const Pose2& pose) {
    const double way = distance(pose, T_map_base) / 0.1;
    const double turned = wrapAngle(pose.theta - T_map_base.theta) / 0.05;
    return misfit(pose) + stiffness * (way * way + turned * turned);
  };
  Pose2 pose = T_map_base;
  double step = std::max(0.04, 0.5 * field_->lattice().resolution());  // m
  double turn = 0.5 * kDirectionStep;                                  // rad
  const double least_step = stiffness > 0.0 ? kLeastStepHere : kLeastStep;
  double best = cost(pose);
  while (step > least_step) {
    const Pose2 moves[] = {{step, 0, 0},  {-step, 0, 0}, {0, step, 0},
                           {0, -step, 0}, {0, 0, turn},  {0, 0, -turn}};
    bool better = false;
    for (const Pose2& move : moves) {
      const Pose2 moved{pose.x + move.x, pose.y + move.y, wrapAngle(pose.theta + move.theta)};
      const double value = cost(moved);
      if (!(value < best)) continue;  // nor what is no number
      best = value;
      pose = moved;
      better = true;
    }
    if (better) continue;
    step *= 0.5;
    turn *= 0.5;
  }
  return {pose, error(pose)};
}

Place PlaceRefiner::align(const Pose2& T_map_base) const {
  constexpr double kStiffness = 0.2;  // m, of the odometry, against the sum over a scan's hits
  const Place moved = refine(T_map_base, kStiffness);
  const Place stayed{T_map_base, error(T_map_base)};
  const bool is_better = moved.error <= stayed.error && areSamePlace(moved.T_map_base, T_map_base);
  return is_better ? moved : stayed;
}

}  // namespace adaptive_localization
