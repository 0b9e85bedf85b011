// SPDX-License-Identifier: BSD-3-Clause
#include "bag_player.hpp"

#include <ros/callback_queue.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include "conversions.hpp"

namespace adaptive_localization {
namespace {

void addTransforms(const rosbag::MessageInstance& message, bool fixed, tf2_ros::Buffer& tf) {
  const auto transforms = message.instantiate<tf2_msgs::TFMessage>();
  if (!transforms) return;
  for (auto transform : transforms->transforms) {
    for (auto* frame : {&transform.header.frame_id, &transform.child_frame_id}) {
      *frame = withoutLeadingSlash(*frame);
    }
    tf.setTransform(transform, "bag", fixed);
  }
}

void addFixedTransforms(const rosbag::Bag& bag, tf2_ros::Buffer& tf) {
  for (const auto& message : rosbag::View(bag)) {
    if (withoutLeadingSlash(message.getTopic()) == "tf_static") addTransforms(message, true, tf);
  }
}

void report(const LocalizationNode& node, const ros::Time& stamp, double seconds) {
  ROS_INFO("Bag complete, took %.1f seconds to process, shutting down", seconds);
  const auto& answer = node.answer();
  if (!answer || answer->status == Status::kUninitialised) {
    ROS_WARN("No pose was found in the bag");
    return;
  }
  ROS_INFO("Final location %.3f, %.3f, %.3f with stamp=%f", answer->T_map_base.x,
           answer->T_map_base.y, answer->T_map_base.theta, stamp.toSec());
}

}  // namespace

void playBag(const std::string& path, LocalizationNode& node, const std::function<bool()>& go_on) {
  const rosbag::Bag bag(path);
  addFixedTransforms(bag, node.tf());
  auto* queue = ros::getGlobalCallbackQueue();
  while (go_on() && !node.hasMap()) queue->callAvailable(ros::WallDuration(0.1));

  const ros::WallTime start = ros::WallTime::now();
  ros::Time stamp;
  for (const auto& message : rosbag::View(bag)) {
    if (!go_on()) return;
    const std::string topic = withoutLeadingSlash(message.getTopic());
    if (topic == "tf") addTransforms(message, false, node.tf());
    if (topic == "base_scan" || node.hearsScansOn(topic)) {
      if (const auto scan = message.instantiate<sensor_msgs::LaserScan>()) {
        node.add(scan);
        stamp = scan->header.stamp;
      }
    }
    queue->callAvailable();
  }
  report(node, stamp, (ros::WallTime::now() - start).toSec());
}

}  // namespace adaptive_localization
