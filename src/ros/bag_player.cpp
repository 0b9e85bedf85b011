// SPDX-License-Identifier: BSD-3-Clause
#include "bag_player.hpp"

#include <ros/callback_queue.h>
#include <tf2_msgs/TFMessage.h>

#include <boost/make_shared.hpp>
#include <stdexcept>

#include "conversions.hpp"

namespace adaptive_localization {
namespace {

void addTransforms(const BagMessage& message, LocalizationNode& node) {
  const auto transforms = message.as<tf2_msgs::TFMessage>();
  if (!transforms) return;
  for (auto transform : transforms->transforms) {
    for (auto* frame : {&transform.header.frame_id, &transform.child_frame_id}) {
      *frame = withoutLeadingSlash(*frame);
    }
    node.add(transform, message.is_fixed);
  }
}

std::string scanTopics(BagStream& bag) {
  std::string topics;
  for (const auto& [topic, type] : bag.types()) {
    if (type == ros::message_traits::DataType<sensor_msgs::LaserScan>::value())
      topics += (topics.empty() ? "" : ", ") + topic;
  }
  return topics.empty() ? "no topic" : topics;
}

void report(const LocalizationNode& node, BagStream& bag, const ros::Time& stamp, double seconds) {
  ROS_INFO("Bag complete, took %.1f seconds to process, shutting down", seconds);
  const auto& answer = node.answer();
  if (!answer || answer->status == Status::kUninitialised) {
    const std::string missing = node.missing();
    ROS_WARN("No pose was found in the bag, whose scans are on %s%s", scanTopics(bag).c_str(),
             missing.empty() ? "" : ("; waited for " + missing).c_str());
    return;
  }
  ROS_INFO("Final location %.3f, %.3f, %.3f with stamp=%f", answer->T_map_base.x,
           answer->T_map_base.y, answer->T_map_base.theta, stamp.toSec());
}

}  // namespace

void playBag(BagStream& bag, LocalizationNode& node, const std::function<bool()>& go_on) {
  bag.types();  // that it can be read is said at once
  auto* queue = ros::getGlobalCallbackQueue();
  while (go_on() && !node.hasMap()) queue->callAvailable(ros::WallDuration(0.1));

  const ros::WallTime start = ros::WallTime::now();
  ros::Time stamp;
  while (const auto message = bag.next()) {
    if (!go_on()) return;
    const std::string topic = withoutLeadingSlash(message->topic);
    if (topic == "tf" || message->is_fixed) addTransforms(*message, node);
    if (topic == "base_scan" || node.hearsScansOn(topic)) {
      if (const auto scan = message->as<sensor_msgs::LaserScan>()) {
        node.add(boost::make_shared<sensor_msgs::LaserScan>(*scan));
        stamp = scan->header.stamp;
      }
    }
    node.hear(*message);
    queue->callAvailable();
  }
  if (!bag.whyStopped().empty())
    throw std::invalid_argument("cannot be read on: " + bag.whyStopped());
  report(node, bag, stamp, (ros::WallTime::now() - start).toSec());
}

}  // namespace adaptive_localization
