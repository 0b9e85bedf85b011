// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/gyroscope.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kStandstill = 1e-4;  // m and rad, from one scan to the next
constexpr double kMostBias = 0.05;    // rad/s; what turns faster is turned
constexpr double kBiasTime = 10.0;    // s, over which the bias is a mean
constexpr double kLongestStep = 1.0;  // s, between scans
constexpr double kSlip = 0.3;         // share of a turn that wheels may slip,
constexpr double kSlipAnyway = 0.2;   // and rad besides
constexpr double kForget = 0.9;       // of what they were apart, from one motion to the next
constexpr double kFromTurn = 0.1;     // odometry's variance from turn,
constexpr double kFromWay = 0.1;      // and from way, rad^2/m^2,
constexpr double kAnyway = 1e-6;      // and rad^2 besides
constexpr double kScaleError = 0.01;  // of a gyroscope

double square(double value) {
  return value * value;
}

}  // namespace

void Gyroscope::restart() {
  last_.reset();
  base_.reset();
  apart_ = 0.0;
  is_doubted_ = false;
}

void Gyroscope::observe(const Pose2& T_odom_base, const Observations& observations) {
  if (!observations.gyro) return restart();
  const Sight now{observations.stamp, T_odom_base, *observations.gyro};
  if (last_ && last_->turn.since == now.turn.since) {
    learnBias(*last_, now);
  } else {
    base_.reset();
  }
  last_ = now;
}

void Gyroscope::learnBias(const Sight& before, const Sight& now) {
  const double seconds = now.stamp - before.stamp;
  const Pose2 motion = between(before.T_odom_base, now.T_odom_base);
  if (!(seconds > 1e-3 && seconds < kLongestStep)) return;
  if (std::hypot(motion.x, motion.y) > kStandstill || std::abs(motion.theta) > kStandstill) return;
  const double rate = (now.turn.angle - before.turn.angle) / seconds;
  if (std::abs(rate) > kMostBias) return;
  stood_ = std::min(stood_ + seconds, kBiasTime);
  bias_ += seconds / stood_ * (rate - bias_);
}

Pose2 Gyroscope::slipDuring(const Pose2& motion) {
  const std::optional<Sight> before = base_;
  base_ = last_;
  if (!before || !last_ || !(last_->stamp > before->stamp)) return {};
  const double seconds = last_->stamp - before->stamp;
  const double turn = last_->turn.angle - before->turn.angle - bias_ * seconds;
  const double off = wrapAngle(turn - motion.theta);
  apart_ = kForget * apart_ + off;
  const double most = kSlipAnyway + kSlip * std::abs(motion.theta);
  is_doubted_ = std::abs(apart_) > (is_doubted_ ? 0.5 * most : most);
  if (is_doubted_) return {};
  const double way2 = square(motion.x) + square(motion.y);
  const double by_odometry = kFromTurn * square(motion.theta) + kFromWay * way2 + kAnyway;
  const double by_gyroscope = square(last_->turn.deviation * seconds) + square(kScaleError * turn);
  const double correction = off * by_odometry / (by_odometry + by_gyroscope);
  const Pose2 half{0.0, 0.0, 0.5 * correction};
  return between(motion, half * motion * half);
}

}  // namespace adaptive_localization
