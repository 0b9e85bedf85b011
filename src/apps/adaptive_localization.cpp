// SPDX-License-Identifier: BSD-3-Clause
#include <ros/callback_queue.h>

#include <csignal>
#include <cstdlib>
#include <exception>

#include "../ros/localization_node.hpp"

namespace {

volatile std::sig_atomic_t stop_requested = 0;

void onSignal(int signal) {
  stop_requested = 1;
  std::signal(signal, SIG_DFL);  // a second one ends the process at once
}

}  // namespace

int main(int argc, char** argv) {
  // roscpp's own handler would close the connection to the master before the pose is kept.
  ros::init(argc, argv, "adaptive_localization", ros::init_options::NoSigintHandler);
  const ros::NodeHandle node;  // outlives the try, else there is no log to say the error in
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  try {
    adaptive_localization::LocalizationNode localization(node, ros::NodeHandle("~"));
    while (ros::ok() && !stop_requested) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
    }
    localization.writePose();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
