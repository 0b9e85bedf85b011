// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <iostream>

#include "../ros/command_line.hpp"
#include "../ros/fiducial_node.hpp"

namespace adaptive_localization {
namespace {

constexpr auto kUsage = R"(usage: fiducials [_PARAMETER:=VALUE ...]

Finds aruco markers in a camera's pictures: takes image and camera_info, publishes landmarks for the
landmark_topic of adaptive_localization. Its parameters and their defaults:

)";

void printUsage(std::ostream& output) {
  output << kUsage;
  for (const auto& option : describe(FiducialNodeOptions{})) {
    output << "  " << option.key << " (" << toText(option.value)
           << (option.unit.empty() ? "" : " " + option.unit) << "): " << option.sentence << '\n';
  }
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  const auto arguments = adaptive_localization::ownArguments(argc, argv);
  if (adaptive_localization::wantsHelp(arguments)) {
    adaptive_localization::printUsage(std::cout);
    return EXIT_SUCCESS;
  }
  ros::init(argc, argv, "fiducials");
  if (!arguments.empty()) {
    ROS_FATAL("fiducials: unknown argument '%s'", arguments[0].c_str());
    return EXIT_FAILURE;
  }
  return adaptive_localization::runNode([](const ros::NodeHandle& node) {
    adaptive_localization::FiducialNode fiducials(node, ros::NodeHandle("~"));
    ros::spin();
  });
}
