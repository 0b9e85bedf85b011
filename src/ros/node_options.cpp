// SPDX-License-Identifier: BSD-3-Clause
#include "node_options.hpp"

#include <ros/console.h>
#include <ros/names.h>

#include <map>
#include <regex>
#include <stdexcept>

#include "adaptive_localization/localizer/localizer.hpp"
#include "conversions.hpp"
#include "core/suggestion.hpp"
#include "places_maker.hpp"
#include "pose_file.hpp"
#include "ros_params.hpp"

namespace adaptive_localization {
namespace {

std::vector<OptionDescription> optionsInEffect(const Parameters& parameters) {
  std::vector<OptionDescription> all = describe(parameters.read<NodeOptions>());
  const auto others = Localizer(parameters, trialMap()).effectiveOptions();
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::string textOf(const std::vector<OptionDescription>& options) {
  std::string text;
  for (const auto& row : options) text += "\n  " + row.key + ": " + toText(row.value);
  return text;
}

/// Whether an option has the names of topics: heading_topic, scan_topics.
bool isOfTopics(const std::string& key) {
  return std::regex_match(key, std::regex(".*_topics?"));
}

}  // namespace

std::vector<OptionDescription> changedOptions(const Parameters& parameters) {
  Parameters defaults;
  for (const char* key : {"filter", "preset", "plugins"}) {
    const auto given = parameters.values().find(key);
    if (given != parameters.values().end()) defaults.set(key, given->second);
  }
  std::map<std::string, OptionValue> values;
  for (const auto& row : optionsInEffect(withCacheDir(defaults))) values[row.key] = row.value;
  for (const auto& row : describe(LocalizerOptions{})) {
    if (defaults.has(row.key)) values[row.key] = row.value;
  }
  std::vector<OptionDescription> changed;
  for (const auto& row : optionsInEffect(parameters)) {
    if (row.value != values[row.key]) changed.push_back(row);
  }
  return changed;
}

NodeOptions withPlainFrames(NodeOptions options) {
  std::map<std::string, std::string> keys;
  const auto take = [&](const std::string& key, std::string& frame) {
    const std::string given = frame;
    frame = withoutLeadingSlash(given);
    const auto [known, is_new] = keys.emplace(frame, key);
    if (is_new && !frame.empty()) return;
    throw std::invalid_argument("option '" + key + "': got '" + given + "', expected " +
                                (is_new ? "the name of a frame" : "another than " + known->second));
  };
  take("global_frame_id", options.global_frame_id);
  take("odom_frame_id", options.odom_frame_id);
  take("base_frame_id", options.base_frame_id);
  return options;
}

void checkTopics(const NodeOptions& options) {
  for (const auto& option : describe(options)) {
    const auto* topics = std::get_if<std::string>(&option.value);
    if (!topics || !isOfTopics(option.key)) continue;
    for (const std::string& name : namesIn(*topics)) {
      std::string reason;
      if (ros::names::validate(name, reason)) continue;
      throw std::invalid_argument("option '" + option.key + "': got '" + name +
                                  "', expected the name of a topic: " + reason);
    }
  }
}

NodeOptions readNodeOptions(const Parameters& parameters) {
  const NodeOptions options = withPlainFrames(parameters.read<NodeOptions>());
  checkTopics(options);
  const Localizer localizer(parameters, trialMap());
  std::vector<std::string> known = keysOf(describe(options));
  for (const auto& key : keysOf(localizer.allOptions())) known.push_back(key);
  reportUnknown(localizer.unknownKeys(), known);
  const auto changed = changedOptions(parameters);
  if (changed.empty()) {
    ROS_INFO("All options have their defaults");
  } else {
    ROS_INFO("Options that differ from the defaults:%s", textOf(changed).c_str());
  }
  ROS_DEBUG_NAMED("options", "Options in effect:%s", textOf(optionsInEffect(parameters)).c_str());
  return options;
}

std::optional<Prior> startOf(const NodeOptions& options) {
  if (!options.pose_file.empty()) {
    try {
      if (const auto pose = readPoseFile(options.pose_file)) {
        ROS_INFO("Starting at (%.3f, %.3f) m, %.1f deg, kept in %s", pose->mean.x, pose->mean.y,
                 pose->mean.theta * 180.0 / kPi, options.pose_file.c_str());
        return *pose;
      }
    } catch (const std::invalid_argument& error) {
      ROS_WARN("Pose file ignored: %s", error.what());
    }
  }
  if (options.start == "wait") return std::nullopt;
  if (options.start == "anywhere") return Anywhere{};
  return options.initialPose();
}

}  // namespace adaptive_localization
