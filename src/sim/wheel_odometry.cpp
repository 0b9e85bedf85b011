// SPDX-License-Identifier: BSD-3-Clause
#include "sim/wheel_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace adaptive_localization {

OdometryOptions OdometryOptions::profile(const std::string& name) {
  OdometryOptions options;
  if (name == "nominal") return options;
  if (name == "ideal") {
    options.odom_wheel_ratio = 1.0;
    options.odom_axle_ratio = 1.0;
    options.odom_wheel_noise = 0.0;
    options.odom_slip_rate = 0.0;
    options.odom_whole_degrees = false;
    return options;
  }
  if (name == "bad") {
    options.odom_wheel_ratio = 1.02;
    options.odom_axle_ratio = 1.08;
    options.odom_wheel_noise = 1e-3;
    options.odom_slip_rate = 0.5;
    options.odom_slip_share = 0.5;
    return options;
  }
  throw std::invalid_argument("option 'profile': got '" + name +
                              "', expected one of ideal, nominal, bad");
}

/// Factor by which the wheels turn more than the body.
double WheelOdometry::slip(double turn_rate, double dt) {
  constexpr double kFastTurn = 0.3;  // rad/s
  constexpr double kDuration = 0.3;  // s
  if (slip_left_ > 0.0) {
    slip_left_ -= dt;
  } else if (std::abs(turn_rate) > kFastTurn && rng_.uniform() < options_.odom_slip_rate * dt) {
    slip_left_ = kDuration;
  }
  return slip_left_ > 0.0 ? 1.0 / std::max(1.0 - options_.odom_slip_share, 0.1) : 1.0;
}

void WheelOdometry::step(const Velocity& velocity, double dt) {
  const double slipping = slip(velocity.turn, dt);
  measured_ =
      is_omni_ ? measuredByFour(velocity, slipping, dt) : measuredByTwo(velocity, slipping, dt);
  T_odom_base_ = T_odom_base_ * arc(measured_, dt);
}

/// A larger wheel turns less for the same way, so the encoder sees less of it.
Velocity WheelOdometry::measuredByTwo(const Velocity& velocity, double slipping, double dt) {
  const double half_turn = velocity.turn * options_.odom_axle / 2.0 * slipping;
  const double unequal = (options_.odom_wheel_ratio - 1.0) / 2.0;
  double left = (velocity.forward - half_turn) * dt / (1.0 - unequal);
  double right = (velocity.forward + half_turn) * dt / (1.0 + unequal);
  left += noise(left);
  right += noise(right);
  const double assumed_axle = options_.odom_axle / options_.odom_axle_ratio;
  return {(left + right) / 2.0 / dt, (right - left) / assumed_axle / dt};
}

/// Rollers at 45 degrees: a wheel's way is that forward, and that aside with one sign at the front
/// left and the rear right, the other at the others; in a turn, lever times the angle.
Velocity WheelOdometry::measuredByFour(const Velocity& velocity, double slipping, double dt) {
  const double lever = options_.odom_axle;  // half the distance along and half of that across
  const double turn = lever * velocity.turn * slipping;
  const double unequal = (options_.odom_wheel_ratio - 1.0) / 2.0;
  const auto way = [&](double sideways, double turning, double radius) {
    const double exact = (velocity.forward + sideways + turning) * dt / radius;
    return exact + noise(exact);
  };
  const double front_left = way(-velocity.aside, -turn, 1.0 - unequal);
  const double rear_left = way(velocity.aside, -turn, 1.0 - unequal);
  const double front_right = way(velocity.aside, turn, 1.0 + unequal);
  const double rear_right = way(-velocity.aside, turn, 1.0 + unequal);
  const double assumed = lever / options_.odom_axle_ratio;
  return {(front_left + rear_left + front_right + rear_right) / 4.0 / dt,
          (front_right + rear_right - front_left - rear_left) / 4.0 / assumed / dt,
          (rear_left + front_right - front_left - rear_right) / 4.0 / dt};
}

Pose2 WheelOdometry::firmwarePose(double after) const {
  return after == 0.0 ? T_odom_base_ : T_odom_base_ * arc(measured_, after);
}

void WheelOdometry::report(double after) {
  constexpr double kCount = 0.485e-3, kMillimetre = 1e-3, kDegree = kPi / 180.0;
  const auto way = [](double from, double to) {
    const double counts = std::nearbyint(to / kCount) - std::nearbyint(from / kCount);
    return std::nearbyint(counts * kCount / kMillimetre) * kMillimetre;
  };
  const Pose2 before = at_report_;
  at_report_ = firmwarePose(after);
  reported_ = {reported_.x + way(before.x, at_report_.x), reported_.y + way(before.y, at_report_.y),
               std::nearbyint(at_report_.theta / kDegree) * kDegree};
}

Pose2 WheelOdometry::pose(double after) const {
  const Pose2 T_odom_base = firmwarePose(after);
  return options_.odom_whole_degrees ? reported_ * (inverse(at_report_) * T_odom_base)
                                     : T_odom_base;
}

}  // namespace adaptive_localization
