// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "core/error_text.hpp"
#include "node_link.hpp"

namespace adaptive_localization {

/// One call of a service, in a thread of its own: whoever serves it may never answer.
template <class Service>
class ServiceCall {
 public:
  ServiceCall(std::string name, const Service& request)
      : name_(std::move(name)), service_(request), thread_([this] { run(); }) {}

  ~ServiceCall() {
    giveUp();
    thread_.join();
  }

  /// s, since the call began.
  double age() const { return steadySeconds() - begin_; }
  double begin() const { return begin_; }

  bool isDone() const { return is_done_; }

  /// s, since it was done; 0 before.
  double secondsDone() const { return is_done_ ? steadySeconds() - end_ : 0.0; }

  /// Once it is done: what went wrong, in words; empty: nothing.
  const std::string& error() const { return error_; }

  /// Once it is done and nothing went wrong.
  const Service& answer() const { return service_; }

  /// Waits no longer: it is done soon.
  void giveUp() {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_given_up_ = true;
    client_.shutdown();
  }

 private:
  void run() {
    try {
      checkNotRemapped(name_);
      error_ = call()         ? ""
               : is_given_up_ ? "no answer from " + name_
                              : name_ + " refused or is gone";
    } catch (...) {
      error_ = errorText();
    }
    end_ = steadySeconds();
    is_done_ = true;
  }

  bool call() {
    constexpr bool kPersistent = true;  // or it could not be given up
    ros::NodeHandle node;
    ros::ServiceClient client = node.serviceClient<Service>(name_, kPersistent);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (is_given_up_) return false;
      client_ = client;
    }
    return client.call(service_);
  }

  const std::string name_;
  const double begin_{steadySeconds()};
  double end_{0.0};  // s
  Service service_;
  std::string error_;
  std::mutex mutex_;
  ros::ServiceClient client_;
  std::atomic<bool> is_given_up_{false};
  std::atomic<bool> is_done_{false};
  std::thread thread_;  // last: it uses all else
};

}  // namespace adaptive_localization
