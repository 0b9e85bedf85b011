// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "adaptive_localization/localizer/localizer.hpp"
#include "node_options.hpp"

namespace adaptive_localization {

/// Fields of amcl that are no options of a component here.
struct AmclFields {
  double gui_publish_rate{-1.0};
  bool restore_defaults{false};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("gui_publish_rate", gui_publish_rate, Range{-1, 1000}, "Hz",
           "Accepted, and without effect as in amcl.");
    option("restore_defaults", restore_defaults, "Go back to the values at the start.");
  }
};

/// Whether the node reads an option at its start alone; a change takes effect at the next one.
inline bool isReadAtStart(const std::string& key) {
  static const std::set<std::string> keys{
      "odom_frame_id",  "base_frame_id", "global_frame_id",
      "scan_topics",    "use_map_topic", "first_map_only",
      "tf_rate",        "pose_file",     "map_origin_is_cell_center",
      "imu_topic",      "heading_topic", "magnetic_field_topic",
      "landmark_topic", "sonar_topics"};
  return keys.count(key) > 0;
}

/// Whether an option names code or a file. Who may send messages may not choose what the node loads
/// and where it writes: these belong to the start alone and are no fields of dynamic_reconfigure.
inline bool namesCodeOrFile(const std::string& key) {
  return key == "plugins" || key == "cache_dir" || key == "line_map" || key == "pose_file" ||
         key == "landmark_map";
}

/// What dynamic_reconfigure's clients see of all options: not where the robot starts, and nothing
/// that names code or files.
inline std::vector<OptionDescription> fieldsOf(const std::vector<OptionDescription>& options,
                                               const AmclFields& amcl) {
  std::vector<OptionDescription> fields;
  for (const auto& option : options) {
    const bool is_start = option.key == "start" || option.key.rfind("initial_", 0) == 0;
    if (!is_start && !namesCodeOrFile(option.key)) fields.push_back(option);
  }
  const auto more = describe(amcl);
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

/// The node's options with those that only its start reads as they are.
inline NodeOptions liveOptions(Parameters parameters, const NodeOptions& now) {
  for (const auto& option : describe(now)) {
    if (isReadAtStart(option.key)) parameters.set(option.key, option.value);
  }
  return withPlainFrames(parameters.read<NodeOptions>());
}

/// All options of node, localizer and filters with the values that parameters give them.
/// Throws std::invalid_argument naming key, value and range.
inline std::vector<OptionDescription> allOptions(const Parameters& parameters) {
  std::vector<OptionDescription> all = describe(parameters.read<NodeOptions>());
  const auto others = Localizer(parameters, trialMap()).allOptions();
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

}  // namespace adaptive_localization
