// SPDX-License-Identifier: BSD-3-Clause
#include "sim/people.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {

People::People(std::shared_ptr<const FreeSpace> free_space, int count, const Rng& rng)
    : free_space_(std::move(free_space)), rng_(rng) {
  for (int i = 0; i < count; ++i) {
    places_.push_back(free_space_->sample(rng_));
    walks_.push_back({places_.back(), rng_.uniform(0.4, 1.2)});
  }
}

/// Somewhere in sight; where nothing is found at once, the person waits and looks again.
void People::chooseGoal(std::size_t i) {
  constexpr int kTries = 5;
  constexpr double kSight = 8.0;      // m
  constexpr double kSlimmer = -0.08;  // m: a person passes where the robot just does not
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const double bearing = rng_.uniform(-kPi, kPi);
    const Eigen::Vector2d goal =
        places_[i] +
        rng_.uniform(0.5, kSight) * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    if (!free_space_->isFree({places_[i], goal}, kSlimmer)) continue;
    walks_[i].goal = goal;
    return;
  }
}

void People::step(double dt, const Eigen::Vector2d& robot) {
  constexpr double kRespect = 0.7;  // m between the centres of person and robot
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Eigen::Vector2d way = walks_[i].goal - places_[i];
    const double length = walks_[i].speed * dt;
    const bool arrived = way.norm() <= length;
    const Eigen::Vector2d next = arrived ? walks_[i].goal : places_[i] + way.normalized() * length;
    const double gap = (next - robot).norm();
    if (gap < kRespect && gap < (places_[i] - robot).norm()) {
      chooseGoal(i);
      continue;
    }
    places_[i] = next;
    if (arrived) chooseGoal(i);
  }
}

double People::range(const Pose2& T_map_ray, double limit) const {
  const Eigen::Vector2d start(T_map_ray.x, T_map_ray.y);
  const Eigen::Vector2d direction(std::cos(T_map_ray.theta), std::sin(T_map_ray.theta));
  for (const auto& place : places_) {
    const Eigen::Vector2d to = place - start;
    const double along = to.dot(direction);
    const double inside = kRadius * kRadius - (to.squaredNorm() - along * along);
    if (inside < 0.0 || along < 0.0) continue;
    limit = std::min(limit, std::max(along - std::sqrt(inside), 0.0));
  }
  return limit;
}

}  // namespace adaptive_localization
