// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>

#include "transform_keeper.hpp"

namespace adaptive_localization {

/// Fills a tf buffer from /tf and /tf_static in a thread of its own, as tf2_ros's
/// TransformListener does, which ends the process at a transform that tf2 throws at. When the clock
/// jumps back, the buffer is emptied.
class TransformInput {
 public:
  explicit TransformInput(tf2_ros::Buffer& buffer);
  ~TransformInput() { thread_.stop(); }

 private:
  void onMessage(const tf2_msgs::TFMessage& message, bool fixed);
  void emptyAfterJump();

  TransformKeeper transforms_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber moving_;
  ros::Subscriber fixed_;
  ros::Time last_;
  ros::AsyncSpinner thread_;
};

}  // namespace adaptive_localization
