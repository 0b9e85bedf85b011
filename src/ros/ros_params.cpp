// SPDX-License-Identifier: BSD-3-Clause
#include "ros_params.hpp"

#include <ros/console.h>

#include <cmath>
#include <set>

namespace adaptive_localization {
namespace {

/// amcl's parameters that some filter, or the node at all, has no use for.
const std::set<std::string>& amclKeys() {
  static const std::set<std::string> keys{"bag_scan_period",
                                          "beam_skip_distance",
                                          "beam_skip_error_threshold",
                                          "beam_skip_threshold",
                                          "do_beamskip",
                                          "gui_publish_rate",
                                          "kld_err",
                                          "kld_z",
                                          "laser_lambda_short",
                                          "laser_likelihood_max_dist",
                                          "laser_max_beams",
                                          "laser_model_type",
                                          "laser_sigma_hit",
                                          "laser_z_hit",
                                          "laser_z_max",
                                          "laser_z_rand",
                                          "laser_z_short",
                                          "max_particles",
                                          "min_particles",
                                          "odom_alpha1",
                                          "odom_alpha2",
                                          "odom_alpha3",
                                          "odom_alpha4",
                                          "odom_alpha5",
                                          "odom_model_type",
                                          "recovery_alpha_fast",
                                          "recovery_alpha_slow",
                                          "resample_interval",
                                          "restore_defaults",
                                          "selective_resampling"};
  return keys;
}

bool isUnfinishedPose(const std::string& key, const OptionValue& value) {
  const auto* number = std::get_if<double>(&value);
  return key.rfind("initial_", 0) == 0 && number && !std::isfinite(*number);
}

/// Copies one value. A text may be a number: rosparam takes 1e-3 for a text.
void copy(const std::string& key, XmlRpc::XmlRpcValue& value, Parameters& parameters) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return parameters.set(key, OptionValue(static_cast<bool>(value)));
    case XmlRpc::XmlRpcValue::TypeInt:
      return parameters.set(key, OptionValue(static_cast<int>(value)));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return parameters.set(key, OptionValue(static_cast<double>(value)));
    case XmlRpc::XmlRpcValue::TypeString:
      return parameters.set(key, static_cast<std::string>(value));
    default:
      ROS_WARN("Parameter '%s' is a list or a group and ignored: expected one value", key.c_str());
  }
}

}  // namespace

Parameters readParameters(const ros::NodeHandle& node) {
  Parameters parameters;
  XmlRpc::XmlRpcValue all;
  if (!node.getParam(node.getNamespace(), all) ||
      all.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
    return parameters;
  }
  Parameters raw;
  for (auto& entry : all) copy(entry.first, entry.second, raw);
  for (const auto& entry : raw.values()) {
    if (isUnfinishedPose(entry.first, entry.second)) {
      ROS_WARN("Parameter '%s' is NaN and ignored", entry.first.c_str());
    } else {
      parameters.set(entry.first, entry.second);
    }
  }
  return parameters;
}

void reportUnknown(const std::vector<std::string>& keys) {
  std::string unused;
  for (const auto& key : keys) {
    if (amclKeys().count(key)) {
      unused += " " + key;
    } else {
      ROS_WARN("Unknown parameter '%s' is ignored", key.c_str());
    }
  }
  if (!unused.empty()) ROS_INFO("Parameters of amcl that have no effect here:%s", unused.c_str());
}

}  // namespace adaptive_localization
