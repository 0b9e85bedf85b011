// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <map>
#include <optional>
#include <string>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Stamps that are so much older than the last one, s, are of another time.
constexpr double kTimeBack = 1.0;

/// Finds jumps of time in the stamps of scans: a bag played again, a simulation started again, a
/// pause. Lasers are told apart by frame, since the clocks of two drivers may disagree.
class StampWatch {
 public:
  /// Seconds from this frame's last stamp to this one if that is a jump, not a step: back by more
  /// than a second or forward by more than ten.
  std::optional<double> jumpTo(const std::string& frame, const ros::Time& stamp);

 private:
  std::map<std::string, ros::Time> last_;
};

/// From the last odometry before its driver was started again to the first one thereafter.
struct Restart {
  ros::Time before, after;

  /// tf makes up what was between.
  bool contains(const ros::Time& stamp) const { return stamp > before && stamp < after; }
};

/// Whether odometry, after a pause, was started again: it stands at its origin, and stood elsewhere
/// before. A robot that only drives past its origin sends odometry all the time.
bool isRestart(const Restart& pause, const Pose2& T_odom_before, const Pose2& T_odom_after);

/// Finds odometry that does not go on from the one before: jumps that no robot can drive, and
/// restarts.
class OdometryWatch {
 public:
  /// Whether this odometry goes on from the last one given.
  bool goesOn(const ros::Time& stamp, const Pose2& T_odom_base,
              const std::optional<Restart>& last_restart);

  void forget() { last_.reset(); }

 private:
  struct Reading {
    ros::Time stamp;
    Pose2 T_odom_base;
  };
  std::optional<Reading> last_;
};

}  // namespace adaptive_localization
