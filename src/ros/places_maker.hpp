// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/ser/ground.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {

/// With a cache_dir where none is given: $ROS_HOME/adaptive_localization, or
/// ~/.ros/adaptive_localization.
Parameters withCacheDir(Parameters parameters);

/// Whether two sets of parameters differ in what they say about energy grid or global search.
bool haveOtherPlaces(const Parameters& these, const Parameters& those);

/// Makes the places of each map, whose energy grids are built in a thread of their own, and tells
/// the log how that goes.
class PlacesMaker {
 public:
  explicit PlacesMaker(ros::NodeHandle node);

  /// The places of a map, to be used once the map is. Their grids are kept in cache_dir or not.
  static std::shared_ptr<Places> make(const Ground& map, const Parameters& parameters,
                                      bool use_cache);

  /// These are looked after from now on; a grid for others is no longer wanted.
  void use(std::shared_ptr<Places> places);

  /// Has a grid built for the laser of this scan, so that it is there when it is needed: lasers
  /// whose geometry changes all the time get one only when somebody asks.
  void prepare(const Scan& scan);

  bool isBuilding() const { return places_ && places_->isBuilding(); }

 private:
  void poll();

  std::shared_ptr<Places> places_;                // of the last map
  std::vector<std::shared_ptr<Places>> retired_;  // of maps before, until their threads end
  std::shared_ptr<const EnergyGrid> known_;
  int built_{0};
  bool is_building_{false};
  ros::WallTime begun_;
  ros::WallTimer timer_;  // while a grid is being built
};

}  // namespace adaptive_localization
