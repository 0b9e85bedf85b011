// SPDX-License-Identifier: BSD-3-Clause
#include "map_builder.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "conversions.hpp"

namespace adaptive_localization {
namespace {

const ros::WallDuration kPollPeriod(0.02);

BuiltMap built(std::shared_ptr<const OccupancyGrid> grid) {
  auto field = std::make_shared<const DistanceField>(*grid);
  return {std::move(grid), std::move(field)};
}

}  // namespace

MapBuilder::MapBuilder(ros::NodeHandle node, const NodeOptions& options, User user)
    : options_(options), user_(std::move(user)) {
  timer_ = node.createWallTimer(
      kPollPeriod, [this](const ros::WallTimerEvent&) { poll(); }, false, false);
}

bool MapBuilder::build(const nav_msgs::OccupancyGrid& message, bool wait) {
  const std::string frame = withoutLeadingSlash(message.header.frame_id);
  if (frame != options_.global_frame_id) {
    ROS_WARN("The map's frame is '%s', but global_frame_id is '%s'", frame.c_str(),
             options_.global_frame_id.c_str());
  }
  Grid grid;
  try {
    grid =
        std::make_shared<const OccupancyGrid>(toGrid(message, options_.map_origin_is_cell_center));
  } catch (const std::invalid_argument& error) {
    ROS_ERROR_THROTTLE(10.0, "Map not used: %s", error.what());
    return false;
  }
  if (wait) return use(built(std::move(grid)));
  if (running_.valid()) {
    next_ = std::move(grid);
  } else {
    start(std::move(grid));
  }
  return true;
}

void MapBuilder::start(Grid grid) {
  ROS_INFO("Preparing a map of %d x %d cells", grid->lattice().width(), grid->lattice().height());
  running_ = std::async(std::launch::async, built, std::move(grid));
  timer_.start();
}

void MapBuilder::poll() {
  if (running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  timer_.stop();
  const BuiltMap map = running_.get();
  if (next_) return start(std::exchange(next_, nullptr));
  use(map);
}

bool MapBuilder::use(const BuiltMap& map) {
  try {
    user_(map);
  } catch (const std::invalid_argument& error) {
    ROS_ERROR_THROTTLE(10.0, "Map not used: %s", error.what());
    return false;
  }
  const Lattice& lattice = map.grid->lattice();
  ROS_INFO("Map of %d x %d cells of %.3f m", lattice.width(), lattice.height(),
           lattice.resolution());
  return true;
}

}  // namespace adaptive_localization
