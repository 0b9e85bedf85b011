// SPDX-License-Identifier: BSD-3-Clause
#include "places_maker.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "callbacks.hpp"

namespace adaptive_localization {
namespace {

const ros::WallDuration kPollPeriod(0.005);
constexpr int kLasers = 4;  // on one robot; a mount that turns would fill the log

template <class Options>
bool differ(const Parameters& these, const Parameters& those) {
  const auto a = describe(these.read<Options>());
  const auto b = describe(those.read<Options>());
  const auto same = [](const auto& x, const auto& y) { return x.value == y.value; };
  return !std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace

Parameters withCacheDir(Parameters parameters) {
  const char* ros_home = std::getenv("ROS_HOME");
  const char* home = std::getenv("HOME");
  if (parameters.has("cache_dir") || !(ros_home || home)) return parameters;
  const std::string parent = ros_home ? ros_home : std::string(home) + "/.ros";
  parameters.set("cache_dir", OptionValue(parent + "/adaptive_localization"));
  return parameters;
}

bool haveOtherPlaces(const Parameters& these, const Parameters& those) {
  return differ<EnergyGridOptions>(these, those) || differ<GlobalSearchOptions>(these, those);
}

PlacesMaker::PlacesMaker(ros::NodeHandle node) {
  timer_ = every(
      node, kPollPeriod, "Energy grid", [this] { poll(); }, false);
}

std::shared_ptr<Places> PlacesMaker::make(const Ground& map, const Parameters& parameters,
                                          bool use_cache) {
  auto options = parameters.read<EnergyGridOptions>();
  if (!use_cache) options.cache_dir.clear();
  return std::make_shared<Places>(map.map, map.field, options,
                                  parameters.read<GlobalSearchOptions>(),
                                  Places::Build::kInBackground);
}

void PlacesMaker::use(std::shared_ptr<Places> places) {
  if (places_ && places_->isBuilding()) {
    places_->stopBuilding();
    retired_.push_back(places_);
    timer_.start();
  }
  places_ = std::move(places);
  known_ = nullptr;
  is_building_ = false;
  built_ = 0;
}

void PlacesMaker::prepare(const Scan& scan) {
  if (!places_) return;
  if (built_ < kLasers) places_->energyGrid(scan);
  if (is_building_ || !places_->isBuilding()) return;
  if (built_ < kLasers) ROS_INFO("Building the energy grid");
  is_building_ = true;
  ++built_;
  begun_ = ros::WallTime::now();
  timer_.start();
}

void PlacesMaker::poll() {
  const auto has_ended = [](const auto& places) {
    return places->newestGrid(), !places->isBuilding();
  };
  retired_.erase(std::remove_if(retired_.begin(), retired_.end(), has_ended), retired_.end());
  const auto grid = places_->newestGrid();
  for (const auto& warning : places_->takeWarnings()) ROS_WARN("%s", warning.c_str());
  if (places_->isBuilding()) return;
  if (retired_.empty()) timer_.stop();
  is_building_ = false;
  if (grid == known_) return;
  known_ = grid;
  if (built_ > kLasers) return;
  ROS_INFO("Energy grid ready: %zu poses, %.1f MB, %s in %.3f s", grid->size(),
           1e-6 * static_cast<double>(grid->ranges().bytes()),
           places_->isNewestFromCache() ? "loaded" : "built",
           (ros::WallTime::now() - begun_).toSec());
}

}  // namespace adaptive_localization
