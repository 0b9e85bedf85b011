// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/time.h>

#include <optional>

namespace adaptive_localization {

/// In front of a callback queue: notes when each message entered the process, though its callback
/// waits for its turn while the node is busy. roscpp's own time of receipt is simulated where time
/// is. Messages that a full queue of a topic drops leave their times to those that come after them.
class ArrivalQueue : public ros::CallbackQueueInterface {
 public:
  explicit ArrivalQueue(ros::CallbackQueueInterface& queue) : queue_(queue) {}

  void addCallback(const ros::CallbackInterfacePtr& callback, uint64_t owner) override;
  void removeByID(uint64_t owner) override { queue_.removeByID(owner); }

  /// Of the message whose callback is running; now, if none is.
  ros::SteadyTime arrival() const { return arrival_.value_or(ros::SteadyTime::now()); }

 private:
  class Arrived;

  ros::CallbackQueueInterface& queue_;
  std::optional<ros::SteadyTime> arrival_;
};

}  // namespace adaptive_localization
