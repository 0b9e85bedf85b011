// SPDX-License-Identifier: BSD-3-Clause
#include "ros_params.hpp"

#include <ros/console.h>

#include <cmath>

#include "core/audience.hpp"
#include "core/suggestion.hpp"
#include "localizer/untuned.hpp"

namespace adaptive_localization {
namespace {

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

void reportUnknown(const std::vector<std::string>& keys, const std::vector<std::string>& known) {
  std::string unused;
  for (const auto& key : keys) {
    if (audienceOf(key) == Audience::kAmcl) {
      unused += " " + key;
    } else {
      ROS_WARN("Unknown parameter '%s' is ignored%s", key.c_str(), suggestion(key, known).c_str());
    }
  }
  if (!unused.empty()) ROS_INFO("Parameters of amcl that have no effect here:%s", unused.c_str());
}

Parameters withoutUntuned(const Parameters& given) {
  const TunedParameters result = tuned(given);
  if (!result.remark.empty()) ROS_INFO("%s", result.remark.c_str());
  return result.parameters;
}

}  // namespace adaptive_localization
