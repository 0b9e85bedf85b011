// SPDX-License-Identifier: BSD-3-Clause
#include "transform_keeper.hpp"

#include <ros/console.h>

#include <stdexcept>
#include <utility>

#include "../bag/stamps.hpp"
#include "conversions.hpp"
#include "core/background.hpp"

namespace adaptive_localization {

void TransformKeeper::add(const geometry_msgs::TransformStamped& transform, bool fixed) {
  const auto added = outcomeOf([&] { return put(transform, fixed); });
  if (added.value) return;
  ROS_WARN_THROTTLE(5.0, "Transform from '%s' to '%s' ignored: %s",
                    transform.child_frame_id.c_str(), transform.header.frame_id.c_str(),
                    added.error.c_str());
}

std::optional<Restart> TransformKeeper::restartBelow(const std::string& parent) const {
  std::optional<Restart> last;
  for (const auto& [name, frame] : frames_) {
    if (frame.parent != parent || !frame.restart) continue;
    if (!last || frame.restart->after > last->after) last = frame.restart;
  }
  return last;
}

void TransformKeeper::clear() {
  buffer_.clear();
  frames_.clear();
}

bool TransformKeeper::put(const geometry_msgs::TransformStamped& transform, bool fixed) {
  const ros::Time& stamp = transform.header.stamp;
  if (!leavesRoom(stamp)) throw std::runtime_error("its stamp is out of range");
  if (!fixed && isNewest(transform.child_frame_id, stamp)) return false;
  const bool is_taken = buffer_.setTransform(transform, "tf", fixed);
  if (is_taken && !fixed) note(transform);
  if (fixed || !isStuck(transform.child_frame_id, stamp, is_taken)) return is_taken;
  ROS_WARN(
      "Transforms of '%s' have been %.1f s behind the newest for a second, which came from "
      "the future: transforms of before are forgotten",
      transform.child_frame_id.c_str(),
      frames_[transform.child_frame_id].newest.toSec() - stamp.toSec());
  clear();
  return put(transform, fixed);
}

void TransformKeeper::note(const geometry_msgs::TransformStamped& transform) {
  Frame& seen = frames_[transform.child_frame_id];
  const std::string parent = withoutLeadingSlash(transform.header.frame_id);
  const Pose2 pose = toPose2(transform.transform);
  const Restart pause{seen.newest, transform.header.stamp};
  if (parent == seen.parent && isRestart(pause, seen.pose, pose)) seen.restart = pause;
  seen.parent = parent;
  seen.pose = pose;
}

/// Whether the last one that was taken had the same stamp: tf2 would log each that comes again.
bool TransformKeeper::isNewest(const std::string& frame, const ros::Time& stamp) const {
  const auto seen = frames_.find(frame);
  return seen != frames_.end() && seen->second.newest == stamp;
}

/// A stray old one says nothing: those of a second, none of which was taken, do.
bool TransformKeeper::isStuck(const std::string& frame, const ros::Time& stamp, bool is_taken) {
  constexpr double kPatience = 1.0;  // s
  Frame& seen = frames_[frame];
  if (is_taken) {
    seen.newest = stamp;
    seen.refused_since = ros::Time();
    return false;
  }
  if (stamp >= seen.newest) return false;  // it was refused for another reason
  if (seen.refused_since.isZero() || stamp < seen.refused_since) seen.refused_since = stamp;
  return stamp.toSec() - seen.refused_since.toSec() >= kPatience;
}

}  // namespace adaptive_localization
