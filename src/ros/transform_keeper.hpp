// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <map>
#include <optional>
#include <string>

#include "adaptive_localization/core/pose2.hpp"
#include "continuity.hpp"

namespace adaptive_localization {

/// Puts transforms into a tf buffer, whatever they are. One that tf2 throws at, which a stamp at
/// the end of time makes it do, is left out with a warning that names its frames; one that comes
/// twice is left out without. One from the future makes tf2 take those that follow for outdated
/// ones and refuse them, until their stamps have come near it: once a frame's have gone on so for a
/// second, the buffer is emptied.
class TransformKeeper {
 public:
  explicit TransformKeeper(tf2::BufferCore& buffer) : buffer_(buffer) {}

  void add(const geometry_msgs::TransformStamped& transform, bool fixed);

  /// The last restart of what publishes a frame below this one, as base below odom: after a pause
  /// it stands at its origin, and stood elsewhere before. Nothing if there was none.
  std::optional<Restart> restartBelow(const std::string& parent) const;

  /// Forgets all but the fixed ones.
  void clear();

 private:
  struct Frame {
    ros::Time newest;         // that tf2 took
    ros::Time refused_since;  // zero: it took the last one
    std::string parent;
    Pose2 pose;  // the newest, in the parent
    std::optional<Restart> restart;
  };

  bool put(const geometry_msgs::TransformStamped& transform, bool fixed);
  void note(const geometry_msgs::TransformStamped& transform);
  bool isNewest(const std::string& frame, const ros::Time& stamp) const;
  bool isStuck(const std::string& frame, const ros::Time& stamp, bool is_taken);

  tf2::BufferCore& buffer_;
  std::map<std::string, Frame> frames_;
};

}  // namespace adaptive_localization
