// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// Writes a node's parameters to the parameter server in a thread of its own: a master that does
/// not answer holds up nobody. Of several values for one key the latest is written. While there is
/// no master, values wait, and a warning says so.
class ParameterWriter {
 public:
  explicit ParameterWriter(const ros::NodeHandle& private_node);

  /// Writes what is left, but waits for the master three seconds at the most.
  ~ParameterWriter();

  ParameterWriter(const ParameterWriter&) = delete;
  ParameterWriter& operator=(const ParameterWriter&) = delete;

  void set(const std::string& key, const OptionValue& value);
  void remove(const std::string& key);

 private:
  class Worker;
  std::shared_ptr<Worker> worker_;  // shared with its thread, which a dead master may hold for ever
  ros::NodeHandle node_;
};

}  // namespace adaptive_localization
