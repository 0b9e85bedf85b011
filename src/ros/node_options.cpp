// SPDX-License-Identifier: BSD-3-Clause
#include "node_options.hpp"

#include <ros/console.h>

#include <stdexcept>

#include "adaptive_localization/localizer.hpp"
#include "conversions.hpp"
#include "pose_file.hpp"
#include "ros_params.hpp"

namespace adaptive_localization {

NodeOptions readNodeOptions(const Parameters& parameters) {
  auto options = parameters.read<NodeOptions>();
  for (auto* frame : {&options.odom_frame_id, &options.base_frame_id, &options.global_frame_id}) {
    *frame = withoutLeadingSlash(*frame);
  }
  const Localizer localizer(parameters, trialMap());
  reportUnknown(localizer.unknownKeys());
  std::string text;
  const auto append = [&text](const std::vector<OptionDescription>& rows) {
    for (const auto& row : rows) text += "\n  " + row.key + ": " + toText(row.value);
  };
  append(describe(options));
  append(localizer.effectiveOptions());
  ROS_INFO("Options in effect:%s", text.c_str());
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
