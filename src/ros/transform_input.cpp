// SPDX-License-Identifier: BSD-3-Clause
#include "transform_input.hpp"

#include "callbacks.hpp"

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kQueue = 100;

}  // namespace

TransformInput::TransformInput(tf2_ros::Buffer& buffer) : transforms_(buffer), thread_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  const auto hear = [this](const std::string& topic, bool fixed) {
    return subscribe<tf2_msgs::TFMessage>(
        node_, topic, kQueue, [this, fixed](const tf2_msgs::TFMessage::ConstPtr& message) {
          onMessage(*message, fixed);
        });
  };
  moving_ = hear("/tf", false);
  fixed_ = hear("/tf_static", true);
  thread_.start();
}

void TransformInput::onMessage(const tf2_msgs::TFMessage& message, bool fixed) {
  const auto held = hold();
  emptyAfterJump();
  for (const auto& transform : message.transforms) transforms_.add(transform, fixed);
}

void TransformInput::emptyAfterJump() {
  const ros::Time now = ros::Time::now();
  if (now < last_) {
    ROS_INFO("The clock jumped back: transforms of before are forgotten");
    transforms_.clear();
  }
  last_ = now;
}

}  // namespace adaptive_localization
