// SPDX-License-Identifier: BSD-3-Clause
#include <ros/callback_queue.h>
#include <ros/console.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "../ros/bag_player.hpp"
#include "../ros/command_line.hpp"
#include "../ros/free_memory.hpp"
#include "../ros/localization_node.hpp"
#include "../ros/stop_signal.hpp"

namespace {

constexpr auto kUsage =
    "usage: adaptive_localization [--verbose] [--run-from-bag BAG [--global-localization]]\n"
    "       with ROS's own arguments: topic:=other_topic _parameter:=value __name:=name\n\n"
    "Localizes a robot with a laser on a map; a drop-in alternative to amcl.\n\n"
    "  --verbose              say all options in effect, not only those that were changed\n"
    "  --run-from-bag BAG     take scans and transforms from a bag, and end with it\n"
    "  --global-localization  start anywhere on the map\n"
    "  --help                 print this\n";

/// Runs the node until a signal or the end of the bag.
void run(std::optional<adaptive_localization::BagStream>& bag,
         const std::vector<std::string>& arguments) {
  adaptive_localization::LocalizationNode localization(ros::NodeHandle(), ros::NodeHandle("~"));
  const auto go_on = [] { return ros::ok() && !adaptive_localization::isStopRequested(); };
  if (arguments.size() == 3) localization.localizeAnywhere();
  try {
    if (bag) adaptive_localization::playBag(*bag, localization, go_on);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("bag '" + arguments[1] + "' " + error.what());
  }
  while (!bag && go_on()) ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
  localization.writePose();
}

/// Takes an argument out; says whether it was there.
bool take(const std::string& flag, std::vector<std::string>& arguments) {
  const auto end = std::remove(arguments.begin(), arguments.end(), flag);
  const bool was_there = end != arguments.end();
  arguments.erase(end, arguments.end());
  return was_there;
}

void showAllOptions() {
  constexpr auto kLogger = ROSCONSOLE_DEFAULT_NAME ".options";
  if (ros::console::set_logger_level(kLogger, ros::console::levels::Debug)) {
    ros::console::notifyLoggerLevelsChanged();
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments = adaptive_localization::ownArguments(argc, argv);
  if (adaptive_localization::wantsHelp(arguments)) {
    std::cout << kUsage;
    return EXIT_SUCCESS;
  }
  adaptive_localization::returnFreedBlocks();
  ros::init(argc, argv, "adaptive_localization", ros::init_options::NoSigintHandler);
  if (take("--verbose", arguments)) showAllOptions();
  const bool from_bag = (arguments.size() == 2 || arguments.size() == 3) &&
                        arguments[0] == "--run-from-bag" &&
                        (arguments.size() == 2 || arguments[2] == "--global-localization");
  if (!arguments.empty() && !from_bag) {
    std::cerr << "adaptive_localization: got '" << arguments.front() << "' with "
              << arguments.size() - 1
              << " more, expected no argument, or --run-from-bag BAG [--global-localization]\n\n"
              << kUsage;
    return EXIT_FAILURE;
  }
  std::optional<adaptive_localization::BagStream> bag;
  try {
    if (from_bag) bag.emplace(arguments[1]);  // before there are threads
  } catch (const std::exception& error) {
    std::cerr << "adaptive_localization: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  const ros::NodeHandle node;  // a signal before the master answers ends the process at once
  adaptive_localization::catchStopSignals();
  return adaptive_localization::runNode([&](const ros::NodeHandle&) { run(bag, arguments); });
}
