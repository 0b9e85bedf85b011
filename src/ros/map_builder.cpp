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

// What is made of a map takes so much, measured. What is unknown around all known cells takes next
// to nothing: 0.05 bytes.
constexpr double kBytesPerCell = 8.0;
constexpr double kBytesPerKnownCell = 28.0;  // more

/// Linux gives memory that it does not have, and kills who uses it: better to ask before.
void checkMemory(const OccupancyGrid& grid) {
  const Lattice& lattice = grid.lattice();
  const double needed = kBytesPerCell * static_cast<double>(grid.known().size()) +
                        kBytesPerKnownCell * static_cast<double>(grid.countKnown());
  const double free = freeMemory();
  if (needed <= free) return;
  std::ostringstream text;
  text.precision(3);
  text << "map size: got " << lattice.width() << " x " << lattice.height() << " cells, which take "
       << 1e-9 * needed << " GB to prepare, expected at most the " << 1e-9 * free
       << " GB that are free";
  throw std::invalid_argument(text.str());
}

/// Throws std::invalid_argument that says why the map cannot be used, if so.
void checkUse(const OccupancyGrid& grid) {
  if (grid.countFree() == 0) throw std::invalid_argument("map: got no free cell");
  checkMemory(grid);
}

/// The message is not kept: it may be far larger than what is known of the map.
std::shared_ptr<const OccupancyGrid> usableGrid(nav_msgs::OccupancyGrid&& message,
                                                bool origin_is_cell_center) {
  const nav_msgs::OccupancyGrid taken = std::move(message);
  auto grid = std::make_shared<const OccupancyGrid>(toGrid(taken, origin_is_cell_center));
  checkUse(*grid);
  return grid;
}

BuiltMap built(std::shared_ptr<const OccupancyGrid> grid, const StopToken& stop) {
  auto field = std::make_shared<const DistanceField>(*grid, stop);
  return {Ground(std::move(grid), std::move(field))};
}

BuiltMap updated(const Ground& map, const std::vector<MapPatch>& patches, const StopToken& stop) {
  auto grid = std::make_shared<const OccupancyGrid>(map.map->with(patches));
  checkUse(*grid);
  auto field = std::make_shared<const DistanceField>(*grid, *map.field, patches, stop);
  return {Ground(std::move(grid), std::move(field)), true};
}

BuiltMap with(const MapBuilder::Work& work, BuiltMap map, const StopToken& stop) {
  stop.check();
  if (work) work(map);
  return map;
}

bool covers(const MapPatch& patch, const MapPatch& other) {
  const auto [x, y] = patch.corner;
  return other.corner.x >= x && other.corner.x + other.width <= x + patch.width &&
         other.corner.y >= y && other.corner.y + other.height <= y + patch.height;
}

}  // namespace

MapBuilder::MapBuilder(ros::NodeHandle node, const NodeOptions& options, User user,
                       std::function<Work()> preparation, std::function<bool()> is_busy)
    : options_(options),
      user_(std::move(user)),
      preparation_(std::move(preparation)),
      is_busy_(std::move(is_busy)) {
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
  newest_ = *grid.value;
  if (wait) return true;
  if (running_.isRunning()) {
    next_ = newest_;
  } else {
    start(newest_);
  }
  return true;
}

/// One that covers others from before makes them superfluous.
void MapBuilder::update(const map_msgs::OccupancyGridUpdate& message) {
  constexpr std::size_t kMost = 10000;
  if (!newest_) throw std::invalid_argument("map update: got one before any map");
  MapPatch patch = toPatch(message);
  checkFits(patch, newest_->lattice());
  const auto is_covered = [&](const MapPatch& other) { return covers(patch, other); };
  patches_.erase(std::remove_if(patches_.begin(), patches_.end(), is_covered), patches_.end());
  if (patches_.size() == kMost) {
    throw std::invalid_argument("map update: got one while " + std::to_string(kMost) + " wait");
  }
  patches_.push_back(std::move(patch));
  timer_.start();
}

/// What is being built is older than what came now; a map that is refused gives up nothing.
void MapBuilder::giveUp() {
  running_.stop();
  is_wanted_ = false;
  next_ = nullptr;
  patches_.clear();
}

void MapBuilder::start(Grid grid) {
  ROS_INFO("Preparing a map of %d x %d cells", grid->lattice().width(), grid->lattice().height());
  is_wanted_ = true;
  is_update_ = false;
  running_.start([grid = std::move(grid), work = preparation_()](const StopToken& stop) {
    return with(work, built(grid, stop), stop);
  });
  timer_.start();
}

void MapBuilder::startUpdate() {
  is_wanted_ = is_update_ = true;
  running_.start([map = used_, patches = std::exchange(patches_, {}),
                  work = preparation_()](const StopToken& stop) {
    return with(work, updated(map, patches, stop), stop);
  });
}

void MapBuilder::poll() {
  if (auto map = running_.poll()) {
    const bool is_wanted = std::exchange(is_wanted_, false);
    if (is_wanted && !use(std::move(*map)) && !is_update_) {
      newest_ = used_.map;
      patches_.clear();
    }
  }
  if (running_.isRunning()) return;
  if (next_) return start(std::exchange(next_, nullptr));
  if (patches_.empty()) return timer_.stop();
  if (!is_busy_()) startUpdate();
}

bool MapBuilder::use(Outcome<BuiltMap> map) {
  if (!map.value) return refuse(map.error);
  const auto used = outcomeOf([&] { return user_(*map.value), true; });
  if (!used.value) return refuse(used.error);
  used_ = Ground(map.value->ground.map, map.value->ground.field);
  const Lattice& lattice = used_.map->lattice();
  if (map.value->is_updated) {
    ROS_INFO_THROTTLE(10.0, "Map updated");
  } else {
    ROS_INFO("Map of %d x %d cells of %.3f m", lattice.width(), lattice.height(),
             lattice.resolution());
  }
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
