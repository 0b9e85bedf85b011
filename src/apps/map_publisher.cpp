// SPDX-License-Identifier: BSD-3-Clause
#include "../ros/map_publisher.hpp"

#include <cstdlib>

#include "adaptive_localization/error_text.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "map_publisher");
  if (argc != 2) {
    ROS_FATAL("usage: map_publisher MAP.yaml");
    return EXIT_FAILURE;
  }
  const ros::NodeHandle node;  // outlives the try, else there is no log to say the error in
  try {
    adaptive_localization::MapPublisher publisher(node, ros::NodeHandle("~"), argv[1]);
    ros::spin();
  } catch (...) {
    ROS_FATAL("%s", adaptive_localization::errorText().c_str());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
