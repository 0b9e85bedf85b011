// SPDX-License-Identifier: BSD-3-Clause
#include "place_refiner.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr Eigen::Index kBeams = 90;  // looked at, of a scan that has more
// Steps are halved down to this, m,
constexpr double kRoughly = 0.02;     // where a place is guessed,
constexpr double kSearched = 0.005;   // for one that was searched,
constexpr double kFollowed = 0.0015;  // and for one that is followed
constexpr double kStiffness = 0.2;    // m, of the odometry, against the sum over a scan's hits

constexpr int kMoves = 6, kNoMove = -1;  // along x, y and theta, to and fro

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

Place PlaceRefiner::refine(const Pose2& T_map_base) const {
  const Pose2 pose = descend(T_map_base, 0.0, kSearched);
  return {pose, error(pose)};
}

Place PlaceRefiner::approach(const Pose2& T_map_base) const {
  const Pose2 pose = descend(T_map_base, kStiffness, kRoughly);
  return {pose, misfit(pose)};
}

Pose2 PlaceRefiner::descend(const Pose2& T_map_base, double stiffness, double least_step) const {
  const auto cost = [&](const Pose2& pose) {
    const double way = distance(pose, T_map_base) / 0.1;
    const double turned = wrapAngle(pose.theta - T_map_base.theta) / 0.05;
    return misfit(pose) + stiffness * (way * way + turned * turned);
  };
  Pose2 pose = T_map_base;
  double step = std::max(0.04, 0.5 * field_->lattice().resolution());  // m
  double turn = 0.5 * kDirectionStep;                                  // rad
  double best = cost(pose);
  int failed = 0, back = kNoMove;  // moves in a row that were no better; the one that goes back
  for (int k = 0; step > least_step; k = (k + 1) % kMoves) {
    const double by = k % 2 == 0 ? 1.0 : -1.0;
    Pose2 moved = pose;
    if (k / 2 == 0) moved.x += by * step;
    if (k / 2 == 1) moved.y += by * step;
    if (k / 2 == 2) moved.theta = wrapAngle(moved.theta + by * turn);
    const double value = k == back ? best : cost(moved);
    if (value < best) {  // not what is no number
      best = value;
      pose = moved;
      failed = 0;
      back = k ^ 1;  // moves come in pairs
    } else if (++failed == kMoves) {
      step *= 0.5;
      turn *= 0.5;
      failed = 0;
      back = kNoMove;
      k = kMoves - 1;  // on with the first
    }
  }
  return pose;
}

Place PlaceRefiner::align(const Pose2& T_map_base) const {
  const Pose2 pose = descend(T_map_base, kStiffness, kFollowed);
  const Place moved{pose, error(pose)};
  const Place stayed{T_map_base, error(T_map_base)};
  const bool is_better = moved.error <= stayed.error && areSamePlace(moved.T_map_base, T_map_base);
  return is_better ? moved : stayed;
}

}  // namespace adaptive_localization
