// SPDX-License-Identifier: BSD-3-Clause
#include "../ros/goal_follower.hpp"

#include <ros/callback_queue.h>

#include <cstdlib>
#include <iostream>

#include "../ros/command_line.hpp"
#include "../ros/stop_signal.hpp"

namespace {

constexpr auto kUsage = R"(usage: goal_follower [_PARAMETER:=VALUE ...]

Drives a robot to goals on move_base_simple/goal by the transform from map to base alone, where
there is no move_base: plans on topic map, commands on cmd_vel. Avoids nothing that the map does
not have. Where it ends on the way, the robot is told to stand. Parameters: global_frame_id,
base_frame_id, robot_radius, and the simulated driver's route_* (p3dx_simulator --help).
)";

}  // namespace

int main(int argc, char** argv) {
  const auto arguments = adaptive_localization::ownArguments(argc, argv);
  if (adaptive_localization::wantsHelp(arguments)) {
    std::cout << kUsage;
    return EXIT_SUCCESS;
  }
  ros::init(argc, argv, "goal_follower", ros::init_options::NoSigintHandler);
  if (!arguments.empty()) {
    ROS_FATAL("goal_follower: unknown argument '%s'", arguments[0].c_str());
    return EXIT_FAILURE;
  }
  const ros::NodeHandle keeps_connection;  // a signal before the master answers ends the process
  adaptive_localization::catchStopSignals();
  return adaptive_localization::runNode([](const ros::NodeHandle& node) {
    adaptive_localization::GoalFollower follower(node, ros::NodeHandle("~"));
    auto* const queue = ros::getGlobalCallbackQueue();
    while (ros::ok() && !adaptive_localization::isStopRequested()) {
      queue->callAvailable(ros::WallDuration(0.1));
    }
    follower.stop();
  });
}
