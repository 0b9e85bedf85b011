// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/sim/route_follower.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

constexpr double kLookAhead = 0.6;  // m
constexpr double kArrived = 0.2;    // m
constexpr double kStep = 0.05;      // m between the points of a way
constexpr double kPatience = 4.0;   // s without moving, beside half a turn, before it gives up
constexpr double kBackOff = 1.0;    // s
constexpr double kMoved = 0.01;     // m

double length(const std::vector<Eigen::Vector2d>& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += (way[i] - way[i - 1]).norm();
  return sum;
}

}  // namespace

RouteFollower::RouteFollower(std::shared_ptr<const FreeSpace> free_space,
                             std::vector<Eigen::Vector2d> route, const RouteOptions& options,
                             Rng rng)
    : free_space_(std::move(free_space)), route_(std::move(route)), options_(options) {
  constexpr int kRandomPlaces = 8;
  while (route_.size() < 2) route_.push_back(free_space_->sample(rng));
  if (route_.size() == 2) {
    for (int i = 2; i < kRandomPlaces; ++i) route_.push_back(free_space_->sample(rng));
  }
  for (auto& waypoint : route_) waypoint = free_space_->nearest(waypoint);
}

std::vector<Eigen::Vector2d> RouteFollower::wayTo(const Eigen::Vector2d& from,
                                                  std::size_t waypoint) const {
  const Eigen::Vector2d& to = route_[waypoint];
  constexpr double kStraightMargin = 0.1;  // m beside the robot, for a line without a plan
  if (!free_space_->isFree({from, to}, kStraightMargin)) return free_space_->path(from, to);
  std::vector<Eigen::Vector2d> way;
  const int steps = static_cast<int>((to - from).norm() / kStep) + 1;
  for (int i = 0; i <= steps; ++i) {
    way.emplace_back(from + (to - from) * (static_cast<double>(i) / steps));
  }
  return way;
}

/// Goes to the nearest way-point in sight, or, if none is, to the one with the shortest way.
void RouteFollower::begin(const Eigen::Vector2d& from) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const bool in_sight : {true, false}) {
    for (std::size_t i = 0; i < route_.size(); ++i) {
      if (in_sight && !free_space_->isFree({from, route_[i]}, 0.0)) continue;
      if ((route_[i] - from).norm() >= shortest) continue;  // no way is shorter than the line
      std::vector<Eigen::Vector2d> way = wayTo(from, i);
      if (length(way) >= shortest) continue;
      shortest = length(way);
      target_ = i;
      way_ = std::move(way);
    }
    if (!way_.empty()) break;
  }
  next_ = 0;
}

void RouteFollower::proceed(const Eigen::Vector2d& from) {
  target_ = (target_ + 1) % route_.size();
  way_ = wayTo(from, target_);
  next_ = 0;
}

/// The farthest point of the way within the look-ahead that the robot can drive straight to; never
/// one that it stands on, in whose direction there is no sense.
const Eigen::Vector2d& RouteFollower::carrot(const Eigen::Vector2d& from) {
  while (next_ + 1 < way_.size() && (way_[next_] - from).norm() < 2.0 * kStep) ++next_;
  std::size_t last = next_;
  while (last + 1 < way_.size() && (way_[last + 1] - from).norm() < kLookAhead) ++last;
  for (std::size_t i = last; i > next_; --i) {
    if (free_space_->isFree({from, way_[i]}, 0.0)) {
      next_ = i;
      break;
    }
  }
  return way_[next_];
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
  if (way_.empty()) begin(here);
  if ((way_.back() - here).norm() < kArrived) {
    ++reached_;
    proceed(here);
  }
  if ((way_[next_] - here).norm() > 2.0 * kLookAhead) way_ = wayTo(here, target_), next_ = 0;

  const Eigen::Vector2d aim = inverse(T_map_base) * carrot(here);
  const double aside = std::atan2(aim.y(), aim.x());
  const double turn =
      std::min(std::max(2.0 * aside, -options_.route_turn_rate), options_.route_turn_rate);
  constexpr double kTurnFirst = 0.5;  // rad
  waiting_ += dt;
  if (waiting_ > kPatience + kPi / options_.route_turn_rate) {
    waiting_ = 0.0;
    backing_ = kBackOff;
    proceed(here);
  }
  if (std::abs(aside) > kTurnFirst) return {0.0, turn};
  if (isBlocked(T_map_base, people)) return {};
  return {options_.route_speed * (1.0 - std::abs(aside) / kTurnFirst), turn};
}

}  // namespace adaptive_localization
