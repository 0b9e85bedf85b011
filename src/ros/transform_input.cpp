// SPDX-License-Identifier: BSD-3-Clause
#include "transform_input.hpp"

#include "callbacks.hpp"
#include "conversions.hpp"

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kQueue = 100;

}  // namespace

TransformInput::TransformInput(tf2_ros::Buffer& buffer) : transforms_(buffer), thread_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  const auto hear = [this](const std::string& topic, bool fixed) {
    return subscribe<tf2_msgs::TFMessage, Event>(
        node_, topic, kQueue, [this, fixed](const Event& event) { onMessage(event, fixed); });
  };
  moving_ = hear("/tf", false);
  fixed_ = hear("/tf_static", true);
  thread_.start();
}

void TransformInput::onMessage(const Event& event, bool fixed) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const auto held = hold();
  emptyAfterJump();
  for (const auto& transform : event.getConstMessage()->transforms) {
    transforms_.add(transform, fixed);
    const std::string frame = withoutLeadingSlash(transform.child_frame_id);
    if (fixed) {
      publishers_.hearFixed(frame, event.getPublisherName());
    } else {
      publishers_.hear(frame, event.getPublisherName(), now);
    }
  }
}

void TransformInput::add(const geometry_msgs::TransformStamped& transform, bool fixed) {
  const auto held = hold();
  transforms_.add(transform, fixed);
}

std::optional<Restart> TransformInput::restartBelow(const std::string& parent) const {
  const std::lock_guard<std::mutex> held(adding_);
  return transforms_.restartBelow(parent);
}

std::string TransformInput::rivals() const {
  const std::lock_guard<std::mutex> held(adding_);
  return publishers_.rivals(ros::SteadyTime::now());
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
