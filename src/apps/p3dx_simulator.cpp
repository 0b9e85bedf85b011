// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <iostream>

#include "../ros/command_line.hpp"
#include "../ros/simulator_node.hpp"

namespace adaptive_localization {
namespace {

/// All parameters with their defaults.
void printUsage(std::ostream& output) {
  output
      << "usage: p3dx_simulator _world:=WORLD.yaml [_PARAMETER:=VALUE ...]\n\n"
         "A simulated Pioneer 3-DX with a SICK LMS: takes cmd_vel; publishes odom, tf, scan and\n"
         "base_pose_ground_truth. Its parameters and their defaults:\n\n";
  for (const auto& rows : {describe(SimulatorNodeOptions{}), describe(SimulationOptions{})}) {
    for (const auto& option : rows) {
      output << "  " << option.key << " (" << toText(option.value)
             << (option.unit.empty() ? "" : " " + option.unit) << "): " << option.sentence << '\n';
    }
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
  if (!arguments.empty()) {
    std::cerr << "p3dx_simulator: unknown argument '" << arguments[0] << "'\n\n";
    adaptive_localization::printUsage(std::cerr);
    return EXIT_FAILURE;
  }
  ros::init(argc, argv, "p3dx_simulator");
  return adaptive_localization::runNode([](const ros::NodeHandle& node) {
    adaptive_localization::SimulatorNode simulator(node, ros::NodeHandle("~"));
    ros::spin();
  });
}
