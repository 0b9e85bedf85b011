// SPDX-License-Identifier: BSD-3-Clause
#include "map_builder.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "callbacks.hpp"
#include "conversions.hpp"
#include "free_memory.hpp"

namespace adaptive_localization {
namespace {

const ros::WallDuration kPollPeriod(0.02);
const ros::WallDuration kSayAgain(10.0);

// What is made of a map takes so much, measured; what is unknown lies mostly outside of all walls.
constexpr double kBytesPerCell = 8.0;
constexpr double kBytesPerKnownCell = 28.0;  // more

/// Linux gives memory that it does not have, and kills who uses it: better to ask before.
void checkMemory(const OccupancyGrid& grid) {
  const Lattice& lattice = grid.lattice();
  const auto known = std::count_if(grid.cells().begin(), grid.cells().end(),
                                   [](std::int8_t value) { return value >= 0; });
  const double needed = kBytesPerCell * static_cast<double>(lattice.size()) +
                        kBytesPerKnownCell * static_cast<double>(known);
  const double free = freeMemory();
  if (needed <= free) return;
  std::ostringstream text;
  text.precision(3);
  text << "map size: got " << lattice.width() << " x " << lattice.height() << " cells, which take "
       << 1e-9 * needed << " GB to prepare, expected at most the " << 1e-9 * free
       << " GB that are free";
  throw std::invalid_argument(text.str());
}

/// A map that can be used, or an exception that says why it cannot be.
std::shared_ptr<const OccupancyGrid> usableGrid(nav_msgs::OccupancyGrid&& message,
                                                bool origin_is_cell_center) {
  auto grid =
      std::make_shared<const OccupancyGrid>(toGrid(std::move(message), origin_is_cell_center));
  if (grid->countFree() == 0) throw std::invalid_argument("map: got no free cell");
  checkMemory(*grid);
  return grid;
}

Ground built(std::shared_ptr<const OccupancyGrid> grid, const StopToken& stop) {
  auto field = std::make_shared<const DistanceField>(*grid, stop);
  return {std::move(grid), std::move(field)};
}

}  // namespace

MapBuilder::MapBuilder(ros::NodeHandle node, const NodeOptions& options, User user)
    : options_(options), user_(std::move(user)) {
  timer_ = every(
      node, kPollPeriod, "Map", [this] { poll(); }, false);
}

bool MapBuilder::build(nav_msgs::OccupancyGrid&& message, bool wait) {
  const std::string frame = withoutLeadingSlash(message.header.frame_id);
  if (frame != options_.global_frame_id) {
    ROS_WARN("The map's frame is '%s', but global_frame_id is '%s'", frame.c_str(),
             options_.global_frame_id.c_str());
  }
  const auto grid =
      outcomeOf([&] { return usableGrid(std::move(message), options_.map_origin_is_cell_center); });
  if (!grid.value) return refuse(grid.error);
  if (wait && !use(outcomeOf([&] { return built(*grid.value, {}); }))) return false;
  giveUp();
  if (wait) return true;
  if (running_.isRunning()) {
    next_ = *grid.value;
  } else {
    start(*grid.value);
  }
  return true;
}

/// What is being built is older than what came now; a map that is refused gives up nothing.
void MapBuilder::giveUp() {
  running_.stop();
  is_wanted_ = false;
  next_ = nullptr;
}

void MapBuilder::start(Grid grid) {
  ROS_INFO("Preparing a map of %d x %d cells", grid->lattice().width(), grid->lattice().height());
  is_wanted_ = true;
  running_.start([grid = std::move(grid)](const StopToken& stop) { return built(grid, stop); });
  timer_.start();
}

void MapBuilder::poll() {
  const auto map = running_.poll();
  if (!map) return;
  timer_.stop();
  if (next_) return start(std::exchange(next_, nullptr));
  if (std::exchange(is_wanted_, false)) use(*map);
}

bool MapBuilder::use(const Outcome<Ground>& map) {
  if (!map.value) return refuse(map.error);
  const auto used = outcomeOf([&] { return user_(*map.value), true; });
  if (!used.value) return refuse(used.error);
  const Lattice& lattice = map.value->map->lattice();
  ROS_INFO("Map of %d x %d cells of %.3f m", lattice.width(), lattice.height(),
           lattice.resolution());
  return true;
}

/// A map may be sent again and again; why it is refused is said now and then.
bool MapBuilder::refuse(const std::string& why) {
  const auto now = ros::WallTime::now();
  if (why == refusal_ && now - refused_ < kSayAgain) return false;
  refusal_ = why;
  refused_ = now;
  ROS_ERROR("Map not used: %s", why.c_str());
  return false;
}

}  // namespace adaptive_localization
