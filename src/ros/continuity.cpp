// SPDX-License-Identifier: BSD-3-Clause
#include "continuity.hpp"

#include <algorithm>
#include <utility>

namespace adaptive_localization {
namespace {

constexpr double kForward = 10.0;  // s; as far as tf remembers
constexpr double kSpeed = 10.0;    // m/s; no robot indoors is faster
constexpr double kSlack = 0.5;     // m; odometry that is fused with something else may be corrected

/// Odometry that was just started stands at its origin.
bool isAtOrigin(const Pose2& T_odom_base) {
  return distance(T_odom_base, Pose2{}) < 0.1 && std::abs(T_odom_base.theta) < 0.1;
}

}  // namespace

std::optional<double> StampWatch::jumpTo(const std::string& frame, const ros::Time& stamp) {
  const auto known = last_.find(frame);
  const double step = known == last_.end() ? 0.0 : stamp.toSec() - known->second.toSec();
  const bool jumped = step < -kTimeBack || step > kForward;
  if (jumped) last_.clear();  // it is one jump, though every laser sees it
  last_[frame] = stamp;
  return jumped ? std::optional<double>(step) : std::nullopt;
}

bool isRestart(const Restart& pause, const Pose2& T_odom_before, const Pose2& T_odom_after) {
  constexpr double kPause = 1.0;  // s
  const bool paused = !pause.before.isZero() && pause.after.toSec() - pause.before.toSec() > kPause;
  return paused && isAtOrigin(T_odom_after) && distance(T_odom_before, T_odom_after) > kSlack;
}

bool OdometryWatch::goesOn(const ros::Time& stamp, const Pose2& T_odom_base,
                           const std::optional<Restart>& last_restart) {
  const auto before = std::exchange(last_, Reading{stamp, T_odom_base});
  if (!before) return true;
  const double seconds = std::abs(stamp.toSec() - before->stamp.toSec());
  const double metres = distance(before->T_odom_base, T_odom_base);
  const bool restarted =
      last_restart && before->stamp < last_restart->after && stamp >= last_restart->after;
  return metres <= kSlack + kSpeed * seconds && !restarted;
}

}  // namespace adaptive_localization
