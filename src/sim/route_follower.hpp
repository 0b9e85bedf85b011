// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "sim/way_follower.hpp"

namespace adaptive_localization {

/// A scripted driver: drives round a list of way-points for ever, from wherever the robot is.
class RouteFollower {
 public:
  /// With an empty route it wanders between random places, drawn once.
  RouteFollower(std::shared_ptr<const FreeSpace> free_space, std::vector<Eigen::Vector2d> route,
                const RouteOptions& options, bool is_omni, Rng rng);

  /// What to command now; to be asked again after dt seconds. Stops for people in front of it; what
  /// stays in the way makes it back off and take the next way-point.
  Velocity steer(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& people, double dt);

  /// Starts anew with the way-point that is nearest by way: the robot has been carried.
  void restart() { follower_.follow({}); }

  /// Way-points reached so far, and the last of them.
  int reached() const { return reached_; }
  const Eigen::Vector2d& lastReached() const { return last_reached_; }
  /// Metres from a point to the way that is being driven, infinity before there is one.
  double distanceFromWay(const Eigen::Vector2d& point) const { return follower_.distanceTo(point); }
  const std::vector<Eigen::Vector2d>& route() const { return route_; }

 private:
  void begin(const Eigen::Vector2d& from);
  void proceed(const Eigen::Vector2d& from);
  bool isBlocked(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& people) const;

  std::shared_ptr<const FreeSpace> free_space_;
  std::vector<Eigen::Vector2d> route_;
  RouteOptions options_;
  WayFollower follower_;
  std::size_t target_{0};
  int reached_{0};
  Eigen::Vector2d last_reached_{0.0, 0.0};
  Eigen::Vector2d last_place_{0.0, 0.0};
  double waiting_{0.0};  // s without moving
  double backing_{0.0};  // s left to drive backward
};

}  // namespace adaptive_localization
