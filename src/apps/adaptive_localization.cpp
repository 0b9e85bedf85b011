// SPDX-License-Identifier: BSD-3-Clause
#include <ros/callback_queue.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "../ros/bag_player.hpp"
#include "../ros/localization_node.hpp"
#include "adaptive_localization/error_text.hpp"

namespace {

constexpr auto kUsage =
    "usage: adaptive_localization [--run-from-bag BAG [--global-localization]]\n"
    "       with ROS's own arguments: topic:=other_topic _parameter:=value __name:=name\n";

volatile std::sig_atomic_t stop_requested = 0;

void onSignal(int signal) {
  stop_requested = 1;
  std::signal(signal, SIG_DFL);  // a second one ends the process at once
}

void play(adaptive_localization::BagStream& bag, const std::string& file,
          adaptive_localization::LocalizationNode& localization,
          const std::function<bool()>& go_on) {
  try {
    adaptive_localization::playBag(bag, localization, go_on);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("bag '" + file + "' " + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  // roscpp's own handler would close the connection to the master before the pose is kept.
  ros::init(argc, argv, "adaptive_localization", ros::init_options::NoSigintHandler);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool from_bag = (arguments.size() == 2 || arguments.size() == 3) &&
                        arguments[0] == "--run-from-bag" &&
                        (arguments.size() == 2 || arguments[2] == "--global-localization");
  if (!arguments.empty() && !from_bag) {
    std::cerr << kUsage;
    return EXIT_FAILURE;
  }
  std::optional<adaptive_localization::BagStream> bag;
  try {
    if (from_bag) bag.emplace(arguments[1]);  // before there are threads
  } catch (const std::exception& error) {
    std::cerr << "adaptive_localization: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  const ros::NodeHandle node;  // outlives the try, else there is no log to say the error in
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  try {
    adaptive_localization::LocalizationNode localization(node, ros::NodeHandle("~"));
    const auto go_on = [] { return ros::ok() && !stop_requested; };
    if (from_bag) {
      if (arguments.size() == 3) localization.localizeAnywhere();
      play(*bag, arguments[1], localization, go_on);
    } else {
      while (go_on()) ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
    }
    localization.writePose();
  } catch (...) {
    ROS_FATAL("%s", adaptive_localization::errorText().c_str());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
