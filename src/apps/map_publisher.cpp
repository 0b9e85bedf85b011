// SPDX-License-Identifier: BSD-3-Clause
#include "../ros/map_publisher.hpp"

#include <cstdlib>
#include <iostream>

#include "../ros/command_line.hpp"

namespace {

constexpr auto kUsage = R"(usage: map_publisher MAP.yaml [_frame_id:=map]

Publishes a map as map_server does: topics map and map_metadata, services static_map and change_map.
)";

}  // namespace

int main(int argc, char** argv) {
  const auto arguments = adaptive_localization::ownArguments(argc, argv);
  if (adaptive_localization::wantsHelp(arguments)) {
    std::cout << kUsage;
    return EXIT_SUCCESS;
  }
  ros::init(argc, argv, "map_publisher");
  if (arguments.size() != 1) {
    ROS_FATAL("got %zu arguments, usage: map_publisher MAP.yaml", arguments.size());
    return EXIT_FAILURE;
  }
  return adaptive_localization::runNode([&](const ros::NodeHandle& node) {
    adaptive_localization::MapPublisher publisher(node, ros::NodeHandle("~"), arguments[0]);
    ros::spin();
  });
}
