// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>

#include "../ros/simulator_node.hpp"
#include "adaptive_localization/error_text.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "p3dx_simulator");
  const ros::NodeHandle node;  // outlives the try, else there is no log to say the error in
  try {
    adaptive_localization::SimulatorNode simulator(node, ros::NodeHandle("~"));
    ros::spin();
  } catch (...) {
    ROS_FATAL("%s", adaptive_localization::errorText().c_str());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
