// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_writer.hpp"

#include <ros/console.h>
#include <ros/master.h>
#include <ros/param.h>

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "callbacks.hpp"

namespace adaptive_localization {
namespace {

constexpr std::chrono::seconds kPause(1);      // between two looks for a master
constexpr std::chrono::seconds kLastWrite(3);  // at the end

using Change = std::optional<OptionValue>;  // nothing: the parameter goes

void write(const std::string& key, const Change& change) {
  if (change) {
    std::visit([&](const auto& value) { ros::param::set(key, value); }, *change);
  } else {
    ros::param::del(key);
  }
}

}  // namespace

class ParameterWriter::Worker {
 public:
  void put(const std::string& key, Change change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    changes_[key] = std::move(change);
    changed_.notify_all();
  }

  void run() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return ending_ || !changes_.empty(); });
      if (changes_.empty()) break;
      if (writeOne(lock) || ending_) continue;
      changed_.wait_for(lock, kPause, [this] { return ending_; });
    }
    ended_ = true;
    changed_.notify_all();
  }

  /// Returns once all is written, or cannot be.
  void end() {
    std::unique_lock<std::mutex> lock(mutex_);
    ending_ = true;
    changed_.notify_all();
    changed_.wait_for(lock, kLastWrite, [this] { return ended_; });
  }

 private:
  /// False without a master: then the change stays, or goes if this is the end.
  bool writeOne(std::unique_lock<std::mutex>& lock) {
    const auto [key, change] = *changes_.begin();
    lock.unlock();
    const bool has_master = ros::master::check();
    if (has_master) {
      write(key, change);
    } else {
      ROS_WARN_THROTTLE(10.0, "No ROS master at %s: localizing goes on, but the pose is not kept",
                        ros::master::getURI().c_str());
    }
    lock.lock();
    const auto now = changes_.find(key);
    if (ending_ && !has_master) {
      changes_.clear();
    } else if (has_master && now->second == change) {  // else it changed in the meantime
      changes_.erase(now);
    }
    return has_master;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Change> changes_;  // that are to be written
  bool ending_{false};
  bool ended_{false};
};

ParameterWriter::ParameterWriter(const ros::NodeHandle& private_node)
    : worker_(std::make_shared<Worker>()), node_(private_node) {
  std::thread([worker = worker_] { worker->run(); }).detach();
}

ParameterWriter::~ParameterWriter() {
  worker_->end();
}

void ParameterWriter::set(const std::string& key, const OptionValue& value) {
  worker_->put(node_.resolveName(key), value);
}

void ParameterWriter::remove(const std::string& key) {
  worker_->put(node_.resolveName(key), std::nullopt);
}

}  // namespace adaptive_localization
