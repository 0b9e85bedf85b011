// SPDX-License-Identifier: BSD-3-Clause
#include "node_link.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ros/callbacks.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kWarnings = 20;
constexpr auto kRefused = "Options stay as they were: ";

}  // namespace

double steadySeconds() {
  return ros::SteadyTime::now().toSec();
}

bool isRemapped(const std::string& name) {
  return ros::names::remap(name) != name;
}

void checkNotRemapped(const std::string& name) {
  if (!isRemapped(name)) return;
  throw std::runtime_error("this rviz was started with " + name + " remapped to " +
                           ros::names::remap(name));
}

NodeLink::NodeLink(const LocalizationNames& names) : names_(names) {
  node_.setCallbackQueue(&queue_);
  listen<diagnostic_msgs::DiagnosticStatus>(names.status, 100);
  listen<geometry_msgs::PoseArray>(names.modes, 10);
  listen<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100);
  listen<rosgraph_msgs::Log>("/rosout_agg", 100);
  listen<dynamic_reconfigure::ConfigDescription>(names.descriptions, 1);
  listen<dynamic_reconfigure::Config>(names.updates, 1);
  if (names.initial_pose.empty() || isRemapped(names.initial_pose)) return;
  poses_ = node_.advertise<geometry_msgs::PoseWithCovarianceStamped>(names.initial_pose, 1);
}

template <class Message>
void NodeLink::listen(const std::string& topic, std::uint32_t queue) {
  if (topic.empty()) return;
  checkNotRemapped(topic);
  subscribers_.push_back(subscribe<Message>(
      node_, topic, queue,
      [this](const typename Message::ConstPtr& message) { onMessage(*message); }));
}

void NodeLink::hear(PanelState& state) {
  state_ = &state;
  queue_.callAvailable();
  state_ = nullptr;
}

template <class Message>
void NodeLink::onMessage(const Message& message) {
  read(message, *state_);
}

void NodeLink::onMessage(const diagnostic_msgs::DiagnosticStatus& message) {
  read(message, *state_);
  state_->heard_at = steadySeconds();
}

void NodeLink::onMessage(const diagnostic_msgs::DiagnosticArray& message) {
  read(message, names_.node, *state_);
}

void NodeLink::onMessage(const rosgraph_msgs::Log& message) {
  if (message.name != names_.node || message.level < rosgraph_msgs::Log::WARN) return;
  warnings_.push_back({steadySeconds(), message.msg});
  if (warnings_.size() > kWarnings) warnings_.pop_front();
}

std::string NodeLink::warningSince(double time) const {
  std::string text;
  for (const Warning& warning : warnings_) {
    if (warning.time < time) continue;
    text = warning.text;
    if (text.rfind(kRefused, 0) == 0) return text.substr(std::string(kRefused).size());
  }
  return text;
}

void NodeLink::tell(const NamedPlace& place, const PanelState& state) {
  checkNotRemapped(names_.initial_pose);
  if (!poses_ || poses_.getNumSubscribers() == 0) {
    throw std::runtime_error(names_.node + " does not hear initial poses");
  }
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = state.frame;
  message.header.stamp = state.places_stamp;  // the node takes it on to where the robot is now
  message.pose.pose.position.x = place.pose.x;
  message.pose.pose.position.y = place.pose.y;
  message.pose.pose.orientation.z = std::sin(place.pose.theta / 2.0);
  message.pose.pose.orientation.w = std::cos(place.pose.theta / 2.0);
  constexpr double kXy = 0.25, kHeading = 0.0685;  // m^2, rad^2
  message.pose.covariance[0] = message.pose.covariance[7] = kXy;
  message.pose.covariance[35] = kHeading;
  poses_.publish(message);
}

}  // namespace adaptive_localization
