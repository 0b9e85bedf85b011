// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Motion of a base in its own frame.
struct Velocity {
  double forward{0.0};  // m/s
  double turn{0.0};     // rad/s, counter-clockwise positive
  double aside{0.0};    // m/s, to the left; of bases that can
};

/// Limits as the p2os and ROSARIA drivers and the Pioneer's firmware set them.
struct DriveBaseOptions {
  std::string base{"differential"};
  double max_speed{0.5};
  double max_turn_rate{1.745};
  double max_accel{0.6};
  double max_turn_accel{2.6};
  double cmd_vel_timeout{0.6};
  double robot_radius{0.28};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("base", base, Choices{"differential", "omni"},
           "Two wheels, or four with rollers (mecanum), which drive aside as well.");
    option("max_speed", max_speed, Range{0.0, 2.2}, "m/s",
           "Fastest drive, forward or backward, or aside.");
    option("max_turn_rate", max_turn_rate, Range{0.0, 8.7}, "rad/s", "Fastest turn.");
    option("max_accel", max_accel, Range{0.01, 100}, "m/s^2", "Largest change of speed.");
    option("max_turn_accel", max_turn_accel, Range{0.01, 100}, "rad/s^2",
           "Largest change of the turn rate.");
    option("cmd_vel_timeout", cmd_vel_timeout, kPositive, "s",
           "The robot stops when no command has come for so long.");
    option("robot_radius", robot_radius, Range{0.01, 2}, "m",
           "Radius of the disc around base_link that must not touch anything.");
  }
};

/// Turns commands into true velocities: watchdog, limits of speed and of acceleration.
class DriveBase {
 public:
  explicit DriveBase(const DriveBaseOptions& options) : options_(options) {}

  void command(const Velocity& wanted, double now);

  /// The velocity during the next dt seconds.
  const Velocity& step(double now, double dt);

  /// It hit something: no way forward, but it can still turn.
  void stop() { velocity_.forward = velocity_.aside = 0.0; }

  /// It was lifted and put down: stands still, the last command is forgotten.
  void halt() { velocity_ = wanted_ = {}; }

  const Velocity& velocity() const { return velocity_; }

 private:
  DriveBaseOptions options_;
  Velocity wanted_;
  Velocity velocity_;
  double commanded_at_{-1e9};
};

/// The motion after dt seconds at constant velocity, exactly (an arc), in the frame at its start.
Pose2 arc(const Velocity& velocity, double dt);

}  // namespace adaptive_localization
