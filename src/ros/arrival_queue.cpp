// SPDX-License-Identifier: BSD-3-Clause
#include "arrival_queue.hpp"

#include <boost/make_shared.hpp>

namespace adaptive_localization {

/// A callback and when it was added.
class ArrivalQueue::Arrived : public ros::CallbackInterface {
 public:
  Arrived(ros::CallbackInterfacePtr callback, std::optional<ros::SteadyTime>& arrival)
      : callback_(std::move(callback)), arrival_(arrival) {}

  CallResult call() override {
    arrival_ = time_;
    const CallResult result = callback_->call();
    arrival_.reset();
    return result;
  }

  bool ready() override { return callback_->ready(); }

 private:
  ros::CallbackInterfacePtr callback_;
  std::optional<ros::SteadyTime>& arrival_;  // while it is called
  ros::SteadyTime time_{ros::SteadyTime::now()};
};

void ArrivalQueue::addCallback(const ros::CallbackInterfacePtr& callback, uint64_t owner) {
  queue_.addCallback(boost::make_shared<Arrived>(callback, arrival_), owner);
}

}  // namespace adaptive_localization
