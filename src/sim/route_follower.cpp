// SPDX-License-Identifier: BSD-3-Clause
#include "sim/route_follower.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

constexpr double kPatience = 4.0;  // s without moving, beside half a turn, before it gives up
constexpr double kBackOff = 1.0;   // s
constexpr double kMoved = 0.01;    // m

double length(const std::vector<Eigen::Vector2d>& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += (way[i] - way[i - 1]).norm();
  return sum;
}

}  // namespace

RouteFollower::RouteFollower(std::shared_ptr<const FreeSpace> free_space,
                             std::vector<Eigen::Vector2d> route, const RouteOptions& options,
                             bool is_omni, Rng rng)
    : free_space_(std::move(free_space)),
      route_(std::move(route)),
      options_(options),
      follower_(free_space_, options, is_omni) {
  constexpr int kRandomPlaces = 8;
  while (route_.size() < 2) route_.push_back(free_space_->sample(rng));
  if (route_.size() == 2) {
    for (int i = 2; i < kRandomPlaces; ++i) route_.push_back(free_space_->sample(rng));
  }
  for (auto& waypoint : route_) waypoint = free_space_->nearest(waypoint);
}

/// Goes to the nearest way-point in sight, or, if none is, to the one with the shortest way.
void RouteFollower::begin(const Eigen::Vector2d& from) {
  double shortest = std::numeric_limits<double>::infinity();
  std::vector<Eigen::Vector2d> chosen;
  for (const bool in_sight : {true, false}) {
    for (std::size_t i = 0; i < route_.size(); ++i) {
      if (in_sight && !free_space_->isFree({from, route_[i]}, 0.0)) continue;
      if ((route_[i] - from).norm() >= shortest) continue;  // no way is shorter than the line
      std::vector<Eigen::Vector2d> way = wayThrough(*free_space_, from, route_[i]);
      if (length(way) >= shortest) continue;
      shortest = length(way);
      target_ = i;
      chosen = std::move(way);
    }
    if (!chosen.empty()) break;
  }
  follower_.follow(std::move(chosen));
}

void RouteFollower::proceed(const Eigen::Vector2d& from) {
  target_ = (target_ + 1) % route_.size();
  follower_.follow(wayThrough(*free_space_, from, route_[target_]));
}

bool RouteFollower::isBlocked(const Pose2& T_map_base,
                              const std::vector<Eigen::Vector2d>& people) const {
  return std::any_of(people.begin(), people.end(), [&](const Eigen::Vector2d& person) {
    const Eigen::Vector2d seen = inverse(T_map_base) * person;
    return seen.x() > 0.0 && seen.x() < 1.0 && std::abs(seen.y()) < 0.5;
  });
}

Velocity RouteFollower::steer(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& people,
                              double dt) {
  const Eigen::Vector2d here(T_map_base.x, T_map_base.y);
  if ((here - last_place_).norm() > kMoved) {
    last_place_ = here;
    waiting_ = 0.0;
  }
  if (backing_ > 0.0) {
    backing_ -= dt;
    return {-options_.route_speed / 2.0, 0.0};
  }
  if (!follower_.hasWay()) begin(here);
  if (follower_.hasArrived(here)) {
    ++reached_;
    last_reached_ = route_[target_];
    proceed(here);
  }
  if (follower_.isOff(here)) follower_.follow(wayThrough(*free_space_, here, route_[target_]));

  const Velocity wanted = follower_.steer(T_map_base, dt);
  waiting_ += dt;
  if (waiting_ > kPatience + kPi / options_.route_turn_rate) {
    waiting_ = 0.0;
    backing_ = kBackOff;
    proceed(here);
  }
  return std::hypot(wanted.forward, wanted.aside) > 0.0 && isBlocked(T_map_base, people)
             ? Velocity{}
             : wanted;
}

}  // namespace adaptive_localization
