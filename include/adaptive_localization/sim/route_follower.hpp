// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "adaptive_localization/sim/drive_base.hpp"
#include "adaptive_localization/sim/free_space.hpp"

namespace adaptive_localization {

struct RouteOptions {
  double route_speed{0.4};
  double route_turn_rate{0.8};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("route_speed", route_speed, Range{0.01, 2.2}, "m/s", "Speed of the scripted drive.");
    option("route_turn_rate", route_turn_rate, Range{0.05, 8.7}, "rad/s",
           "Turn rate of the scripted drive.");
  }
};

/// A scripted driver that knows the truth: drives round a list of way-points for ever, from
/// wherever the robot is. Pure pursuit (Coulter 1992) of a point on the way that is in sight; turns
/// on the spot first when it lies far aside.
class RouteFollower {
 public:
  /// With an empty route it wanders between random places, drawn once.
  RouteFollower(std::shared_ptr<const FreeSpace> free_space, std::vector<Eigen::Vector2d> route,
                const RouteOptions& options, Rng rng);

  /// What to command now; to be asked again after dt seconds. Stops for people in front of it; what
  /// stays in the way makes it back off and take the next way-point.
  Velocity steer(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& people, double dt);

  /// Starts anew with the way-point that is nearest by way: the robot has been carried.
  void restart() { way_.clear(); }

  /// Way-points reached so far.
  int reached() const { return reached_; }
  const std::vector<Eigen::Vector2d>& route() const { return route_; }

 private:
  std::vector<Eigen::Vector2d> wayTo(const Eigen::Vector2d& from, std::size_t waypoint) const;
  void begin(const Eigen::Vector2d& from);
  void proceed(const Eigen::Vector2d& from);
  const Eigen::Vector2d& carrot(const Eigen::Vector2d& from);
  bool isBlocked(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& people) const;

  std::shared_ptr<const FreeSpace> free_space_;
  std::vector<Eigen::Vector2d> route_;
  RouteOptions options_;
  std::size_t target_{0};
  std::vector<Eigen::Vector2d> way_;  // to the target, dense; empty: to be chosen
  std::size_t next_{0};               // how far along the way the robot is
  int reached_{0};
  Eigen::Vector2d last_place_{0.0, 0.0};
  double waiting_{0.0};  // s without moving
  double backing_{0.0};  // s left to drive backward
};

}  // namespace adaptive_localization
