// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <functional>
#include <string>
#include <utility>

#include "callbacks.hpp"

namespace adaptive_localization {

/// A latched topic whose messages are made from the first subscriber on; it gets the newest, as
/// every later one does. They are made on when all are gone, since roscpp keeps the message that
/// the next subscriber is handed first.
template <class Message>
class LatchedTopic {
 public:
  /// `make` tells the newest.
  LatchedTopic(ros::NodeHandle node, const std::string& topic, std::function<Message()> make)
      : make_(std::move(make)),
        publisher_(advertiseLatched<Message>(node, topic, 2, [this] { onSubscriber(); })) {}
  LatchedTopic(const LatchedTopic&) = delete;
  LatchedTopic& operator=(const LatchedTopic&) = delete;

  /// There is a new one.
  void publish() {
    has_newest_ = true;
    if (is_heard_) publisher_.publish(make_());
  }

 private:
  void onSubscriber() {
    if (!std::exchange(is_heard_, true) && has_newest_) publisher_.publish(make_());
  }

  std::function<Message()> make_;
  bool has_newest_{false};
  bool is_heard_{false};
  ros::Publisher publisher_;
};

}  // namespace adaptive_localization
