// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>

#include <mutex>
#include <optional>
#include <string>

#include "frame_publishers.hpp"
#include "transform_keeper.hpp"

namespace adaptive_localization {

/// Fills a tf buffer from /tf and /tf_static in a thread of its own, as tf2_ros's
/// TransformListener does, which ends the process at a transform that tf2 throws at. When the clock
/// jumps back, the buffer is emptied.
class TransformInput {
 public:
  explicit TransformInput(tf2_ros::Buffer& buffer);
  ~TransformInput() { thread_.stop(); }

  /// One that comes from elsewhere, as from a bag.
  void add(const geometry_msgs::TransformStamped& transform, bool fixed);

  /// As TransformKeeper has it.
  std::optional<Restart> restartBelow(const std::string& parent) const;

  /// As long as the lock lives, no transform is added. tf2_ros::MessageFilter::add needs this: a
  /// message whose transform comes while it is being added is never handed on.
  std::unique_lock<std::mutex> hold() { return std::unique_lock(adding_); }

  /// Frames that two nodes publish, in words; empty if there is none.
  std::string rivals() const;

 private:
  using Event = ros::MessageEvent<const tf2_msgs::TFMessage>;

  void onMessage(const Event& event, bool fixed);
  void emptyAfterJump();

  TransformKeeper transforms_;
  FramePublishers publishers_;
  mutable std::mutex adding_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber moving_;
  ros::Subscriber fixed_;
  ros::Time last_;
  ros::AsyncSpinner thread_;
};

}  // namespace adaptive_localization
