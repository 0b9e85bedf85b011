// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>

#include <deque>
#include <string>
#include <vector>

#include "node_graph.hpp"
#include "panel_state.hpp"

namespace adaptive_localization {

/// Hears one localization node and tells it initial poses. Made and destroyed where waiting for the
/// master does no harm; all else returns at once and belongs to one thread.
class NodeLink {
 public:
  /// Throws ros::Exception for names that ROS refuses, and std::runtime_error for one that this
  /// process remaps, so that it would hear another node.
  explicit NodeLink(const LocalizationNames& names);

  const LocalizationNames& names() const { return names_; }

  /// Takes over the messages that came since.
  void hear(PanelState& state);

  /// Sends an initial pose with the covariance that rviz's tool and amcl have: 0.5 m, 15 degrees.
  /// Throws std::runtime_error if nobody hears it or another node would.
  void tell(const NamedPlace& place, const PanelState& state);

  /// What the node warned of since a time in s of the steady clock; empty: nothing was heard. That
  /// options were refused comes before all else.
  std::string warningSince(double time) const;

 private:
  struct Warning {
    double time{0.0};  // s, steady
    std::string text;
  };

  template <class Message>
  void listen(const std::string& topic, std::uint32_t queue);
  void onMessage(const diagnostic_msgs::DiagnosticArray& message);
  void onMessage(const diagnostic_msgs::DiagnosticStatus& message);
  void onMessage(const rosgraph_msgs::Log& message);
  template <class Message>
  void onMessage(const Message& message);

  const LocalizationNames names_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  PanelState* state_{nullptr};  // while messages are being heard
  std::deque<Warning> warnings_;
  ros::Publisher poses_;
  std::vector<ros::Subscriber> subscribers_;
};

/// s of a clock that only goes on.
double steadySeconds();

/// Whether this process remaps a resolved name to another.
bool isRemapped(const std::string& name);

/// Throws std::runtime_error, with both names, if it does.
void checkNotRemapped(const std::string& name);

}  // namespace adaptive_localization
