// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/sim/drive_base.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

double clampTo(double value, double limit) {
  return std::min(std::max(value, -limit), limit);
}

}  // namespace

void DriveBase::command(const Velocity& wanted, double now) {
  if (!std::isfinite(wanted.forward) || !std::isfinite(wanted.turn)) return;
  wanted_ = {clampTo(wanted.forward, options_.max_speed),
             clampTo(wanted.turn, options_.max_turn_rate)};
  commanded_at_ = now;
}

const Velocity& DriveBase::step(double now, double dt) {
  const Velocity goal = now - commanded_at_ <= options_.cmd_vel_timeout ? wanted_ : Velocity{};
  velocity_.forward += clampTo(goal.forward - velocity_.forward, options_.max_accel * dt);
  velocity_.turn += clampTo(goal.turn - velocity_.turn, options_.max_turn_accel * dt);
  return velocity_;
}

Pose2 arc(const Velocity& velocity, double dt) {
  const double angle = velocity.turn * dt;
  const double length = velocity.forward * dt;
  if (std::abs(angle) < 1e-9) return {length, 0.0, angle};
  const double radius = length / angle;
  return {radius * std::sin(angle), radius * (1.0 - std::cos(angle)), wrapAngle(angle)};
}

}  // namespace adaptive_localization
