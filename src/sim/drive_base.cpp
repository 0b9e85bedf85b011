// SPDX-License-Identifier: BSD-3-Clause
#include "sim/drive_base.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

double clampTo(double value, double limit) {
  return std::min(std::max(value, -limit), limit);
}

}  // namespace

void DriveBase::command(const Velocity& wanted, double now) {
  if (!std::isfinite(wanted.forward + wanted.turn + wanted.aside)) return;
  wanted_ = {clampTo(wanted.forward, options_.max_speed),
             clampTo(wanted.turn, options_.max_turn_rate),
             options_.base == "omni" ? clampTo(wanted.aside, options_.max_speed) : 0.0};
  commanded_at_ = now;
}

const Velocity& DriveBase::step(double now, double dt) {
  const Velocity goal = now - commanded_at_ <= options_.cmd_vel_timeout ? wanted_ : Velocity{};
  velocity_.forward += clampTo(goal.forward - velocity_.forward, options_.max_accel * dt);
  velocity_.aside += clampTo(goal.aside - velocity_.aside, options_.max_accel * dt);
  velocity_.turn += clampTo(goal.turn - velocity_.turn, options_.max_turn_accel * dt);
  return velocity_;
}

Pose2 arc(const Velocity& velocity, double dt) {
  const double angle = velocity.turn * dt;
  const double length = velocity.forward * dt, aside = velocity.aside * dt;
  if (std::abs(angle) < 1e-9) return {length, aside, angle};
  const double radius = length / angle, radius_aside = aside / angle;
  const double sine = std::sin(angle), rest = 1.0 - std::cos(angle);
  return {radius * sine - radius_aside * rest, radius * rest + radius_aside * sine,
          wrapAngle(angle)};
}

}  // namespace adaptive_localization
