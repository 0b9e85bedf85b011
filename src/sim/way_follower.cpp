// SPDX-License-Identifier: BSD-3-Clause
#include "sim/way_follower.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "map/polygon.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLookAhead = 0.6;               // m
constexpr double kStep = 0.05;                   // m between the points of a way
constexpr double kTurnFirst = 0.5;               // rad aside, where it turns on the spot
constexpr double kMostIntegral = 0.5;            // rad s
constexpr double kBraking = 1.0, kCreep = 0.03;  // 1/s, m/s

}  // namespace

void WayFollower::follow(std::vector<Eigen::Vector2d> way) {
  way_ = std::move(way);
  next_ = 0;
  integral_ = last_aside_ = 0.0;
}

bool WayFollower::hasArrived(const Eigen::Vector2d& here) const {
  return hasWay() && (way_.back() - here).norm() < options_.route_arrival;
}

bool WayFollower::isOff(const Eigen::Vector2d& here) const {
  return hasWay() && (way_[next_] - here).norm() > 2.0 * kLookAhead;
}

double WayFollower::distanceTo(const Eigen::Vector2d& point) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < way_.size(); ++i)
    least = std::min(least, distance(Segment{way_[i - 1], way_[i]}, point));
  return least;
}

/// The farthest point of the way within the look-ahead that the robot can drive straight to; never
/// one that it stands on, in whose direction there is no sense.
const Eigen::Vector2d& WayFollower::carrot(const Eigen::Vector2d& from) {
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

Velocity WayFollower::steer(const Pose2& T_map_base, double dt) {
  if (!hasWay()) return {};
  const Eigen::Vector2d here(T_map_base.x, T_map_base.y);
  const Eigen::Vector2d aim = inverse(T_map_base) * carrot(here);
  const double aside = std::atan2(aim.y(), aim.x());
  integral_ = std::clamp(integral_ + aside * dt, -kMostIntegral, kMostIntegral);
  const double change = wrapAngle(aside - last_aside_) / dt;
  last_aside_ = aside;
  const double wanted =
      options_.route_p * aside + options_.route_i * integral_ + options_.route_d * change;
  const double turn = std::clamp(wanted, -options_.route_turn_rate, options_.route_turn_rate);
  if (std::abs(aside) > kTurnFirst && !is_omni_) return {0.0, turn};
  double speed = options_.route_speed;
  if (options_.route_brakes) {
    speed = std::min(speed, std::max(kCreep, kBraking * (way_.back() - here).norm()));
  }
  if (is_omni_) return {speed * std::cos(aside), turn, speed * std::sin(aside)};
  return {speed * (1.0 - std::abs(aside) / kTurnFirst), turn};
}

std::vector<Eigen::Vector2d> wayThrough(const FreeSpace& free_space, const Eigen::Vector2d& from,
                                        const Eigen::Vector2d& to) {
  constexpr double kStraightMargin = 0.1;  // m beside the robot, for a line without a plan
  if (!free_space.isFree({from, to}, kStraightMargin)) return free_space.path(from, to);
  std::vector<Eigen::Vector2d> way;
  const int steps = static_cast<int>((to - from).norm() / kStep) + 1;
  for (int i = 0; i <= steps; ++i) {
    way.emplace_back(from + (to - from) * (static_cast<double>(i) / steps));
  }
  return way;
}

}  // namespace adaptive_localization
