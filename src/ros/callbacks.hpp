// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <functional>
#include <string>
#include <type_traits>
#include <utility>

#include "core/error_text.hpp"

namespace adaptive_localization {

// The boundary between roscpp and the nodes: the only place that hands functions to it. Whatever is
// thrown behind it becomes one line in the log, and the node lives on.

/// A function that throws nothing. If it fails, an error is logged (now and then, if it goes on
/// failing) that names `what`, and a value-initialised result returned: false, say.
template <class Result, class... Arguments>
std::function<Result(Arguments...)> guarded(std::string what,
                                            std::function<Result(Arguments...)> function) {
  return [what = std::move(what), function = std::move(function)](Arguments... arguments) {
    try {
      return function(std::forward<Arguments>(arguments)...);
    } catch (...) {
      ROS_ERROR_THROTTLE(5.0, "%s: %s", what.c_str(), errorText().c_str());
    }
    return Result();
  };
}

/// Hears messages of a topic; one that its handler fails at is dropped. A handler of pointers to
/// messages that are not constant may take them apart: it gets a copy if anybody else has one. In
/// place of a pointer it may take a ros::MessageEvent, which knows who sent the message.
template <class Message, class Pointer = typename Message::ConstPtr>
ros::Subscriber subscribe(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue,
                          std::function<void(const std::common_type_t<Pointer>&)> handler) {
  return node.subscribe<Message, const Pointer&>(
      topic, queue,
      boost::function<void(const Pointer&)>(
          guarded("Message on topic '" + topic + "' ignored", std::move(handler))));
}

/// A latched topic whose publisher is told when somebody subscribes to it.
template <class Message>
ros::Publisher advertiseLatched(ros::NodeHandle& node, const std::string& topic,
                                std::uint32_t queue, std::function<void()> on_subscriber) {
  const auto call = guarded("Subscriber of topic '" + topic + "'", std::move(on_subscriber));
  return node.advertise<Message>(
      topic, queue, [call](const ros::SingleSubscriberPublisher&) { call(); },
      ros::SubscriberStatusCallback(), ros::VoidConstPtr(), true);
}

/// Serves a service; a request that its handler fails at is refused.
template <class Service>
ros::ServiceServer serve(
    ros::NodeHandle& node, const std::string& name,
    std::function<bool(typename Service::Request&, typename Service::Response&)> handler) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  return node.advertiseService(
      name, boost::function<bool(Request&, Response&)>(
                guarded("Request of service '" + name + "' refused", std::move(handler))));
}

/// Calls a function again and again in real time; it need not be called at once.
inline ros::WallTimer every(ros::NodeHandle& node, const ros::WallDuration& period,
                            const std::string& what, std::function<void()> function,
                            bool at_once = true) {
  const auto call = guarded(what, std::move(function));
  return node.createWallTimer(
      period, [call](const ros::WallTimerEvent&) { call(); }, false, at_once);
}

/// The same in ROS's time, which may be simulated.
inline ros::Timer every(ros::NodeHandle& node, const ros::Duration& period, const std::string& what,
                        std::function<void()> function) {
  const auto call = guarded(what, std::move(function));
  return node.createTimer(period, [call](const ros::TimerEvent&) { call(); });
}

}  // namespace adaptive_localization
