// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/ros.h>

#include <functional>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "parameter_writer.hpp"
#include "reconfigure_messages.hpp"

namespace adaptive_localization {

/// All options as fields of dynamic_reconfigure, made at run time from the options' own list, so
/// that those of a plug-in are among them. Values in effect stand on the parameter server.
class Reconfigure {
 public:
  /// Applies parameters and returns all options with their values in effect, or throws
  /// std::invalid_argument and leaves everything as it was.
  using Apply = std::function<std::vector<OptionDescription>(const Parameters&)>;

  /// `given` are the parameters at the start, which `restore_defaults` goes back to.
  Reconfigure(const ros::NodeHandle& private_node, ParameterWriter& server, const Parameters& given,
              Apply apply);

  /// Takes those values off the parameter server that are neither given nor set, so that they do
  /// not override another core's presets at the next start.
  ~Reconfigure();

 private:
  using Service = dynamic_reconfigure::Reconfigure;

  bool onRequest(Service::Request& request, Service::Response& response);
  void change(const Values& values);
  Values understood(const Values& values) const;
  const OptionDescription* find(const std::string& key) const;
  void apply(const Parameters& parameters);
  void publish();

  ros::NodeHandle node_;
  ParameterWriter& server_;
  Apply apply_;
  Parameters at_start_;
  Parameters given_;
  std::vector<OptionDescription> fields_;  // with the values in effect
  Values written_;                         // to the parameter server
  std::size_t described_{0};               // number of fields
  ros::Publisher descriptions_;
  ros::Publisher updates_;
  ros::ServiceServer service_;
};

}  // namespace adaptive_localization
