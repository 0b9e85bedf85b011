// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <exception>

#include "../ros/simulator_node.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "p3dx_simulator");
  const ros::NodeHandle node;  // outlives the try, else there is no log to say the error in
  try {
    adaptive_localization::SimulatorNode simulator(node, ros::NodeHandle("~"));
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
