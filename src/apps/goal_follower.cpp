// SPDX-License-Identifier: BSD-3-Clause
#include "../ros/goal_follower.hpp"

#include <cstdlib>
#include <iostream>

#include "../ros/command_line.hpp"

namespace {

constexpr auto kUsage = R"(usage: goal_follower [_PARAMETER:=VALUE ...]

Drives a robot to goals on move_base_simple/goal by the transform from map to base alone, where
there is no move_base: plans on topic map, commands on cmd_vel. Avoids nothing that the map does
not have. Parameters: global_frame_id, base_frame_id, robot_radius, and the simulated driver's
route_* (p3dx_simulator --help).
)";

}  // namespace

int main(int argc, char** argv) {
  const auto arguments = adaptive_localization::ownArguments(argc, argv);
  if (adaptive_localization::wantsHelp(arguments)) {
    std::cout << kUsage;
    return EXIT_SUCCESS;
  }
  ros::init(argc, argv, "goal_follower");
  if (!arguments.empty()) {
    ROS_FATAL("goal_follower: unknown argument '%s'", arguments[0].c_str());
    return EXIT_FAILURE;
  }
  return adaptive_localization::runNode([](const ros::NodeHandle& node) {
    adaptive_localization::GoalFollower follower(node, ros::NodeHandle("~"));
    ros::spin();
  });
}
