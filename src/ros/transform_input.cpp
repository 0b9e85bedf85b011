// SPDX-License-Identifier: BSD-3-Clause
#include "transform_input.hpp"

#include <stdexcept>

#include "adaptive_localization/core/background.hpp"
#include "callbacks.hpp"
#include "stamps.hpp"

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kQueue = 100;

}  // namespace

void addTransform(const geometry_msgs::TransformStamped& transform, bool fixed,
                  tf2_ros::Buffer& buffer) {
  const auto added = outcomeOf([&] {
    if (!leavesRoom(transform.header.stamp)) throw std::runtime_error("its stamp is out of range");
    return buffer.setTransform(transform, "tf", fixed);
  });
  if (added.value) return;
  ROS_WARN_THROTTLE(5.0, "Transform from '%s' to '%s' ignored: %s",
                    transform.child_frame_id.c_str(), transform.header.frame_id.c_str(),
                    added.error.c_str());
}

TransformInput::TransformInput(tf2_ros::Buffer& buffer) : buffer_(buffer), thread_(1, &queue_) {
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
  emptyAfterJump();
  for (const auto& transform : message.transforms) addTransform(transform, fixed, buffer_);
}

void TransformInput::emptyAfterJump() {
  const ros::Time now = ros::Time::now();
  if (now < last_) {
    ROS_INFO("The clock jumped back: transforms of before are forgotten");
    buffer_.clear();
  }
  last_ = now;
}

}  // namespace adaptive_localization
