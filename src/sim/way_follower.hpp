// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "sim/drive_base.hpp"
#include "sim/free_space.hpp"

namespace adaptive_localization {

struct RouteOptions {
  double route_speed{0.4};
  double route_turn_rate{0.8};
  double route_p{2.0};
  double route_i{0.0};
  double route_d{0.0};
  double route_arrival{0.2};
  bool route_brakes{false};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("route_speed", route_speed, Range{0.01, 2.2}, "m/s", "Speed of the scripted drive.");
    option("route_turn_rate", route_turn_rate, Range{0.05, 8.7}, "rad/s",
           "Turn rate of the scripted drive.");
    option("route_p", route_p, Range{0, 100}, "1/s",
           "Turn rate by the angle at which the way ahead lies aside.");
    option("route_i", route_i, Range{0, 100}, "1/s^2", "The same by the angle's integral.");
    option("route_d", route_d, Range{0, 100}, "", "The same by the angle's derivative.");
    option("route_arrival", route_arrival, Range{0.01, 2}, "m",
           "A way-point is reached within this.");
    option("route_brakes", route_brakes, "Slow down before each way-point.");
  }
};

/// Steers a disc along a way: pursues a point on it that is in sight (pure pursuit, Coulter 1992)
/// with a PID controller for the turn rate,
///
///     turn = p a + i integral(a) + d da/dt,   a the angle at which that point lies aside,
///
/// and turns on the spot first when it lies far aside. A base that can drives there at once,
/// whatever it faces.
class WayFollower {
 public:
  WayFollower(std::shared_ptr<const FreeSpace> free_space, const RouteOptions& options,
              bool is_omni = false)
      : free_space_(std::move(free_space)), options_(options), is_omni_(is_omni) {}

  /// Points at most a few centimetres apart, in the map frame; none: nowhere to go.
  void follow(std::vector<Eigen::Vector2d> way);

  bool hasWay() const { return !way_.empty(); }
  bool hasArrived(const Eigen::Vector2d& here) const;
  /// Too far off the way to go on with it.
  bool isOff(const Eigen::Vector2d& here) const;

  /// What to command now; to be asked again after dt seconds. Stands without a way.
  Velocity steer(const Pose2& T_map_base, double dt);

  /// Metres from a point to the way, infinity without one.
  double distanceTo(const Eigen::Vector2d& point) const;

 private:
  const Eigen::Vector2d& carrot(const Eigen::Vector2d& from);

  std::shared_ptr<const FreeSpace> free_space_;
  RouteOptions options_;
  bool is_omni_;
  std::vector<Eigen::Vector2d> way_;
  std::size_t next_{0};  // how far along the way the robot is
  double integral_{0.0}, last_aside_{0.0};
};

/// From one point to another: straight where there is room beside the robot, else planned.
std::vector<Eigen::Vector2d> wayThrough(const FreeSpace& free_space, const Eigen::Vector2d& from,
                                        const Eigen::Vector2d& to);

}  // namespace adaptive_localization
