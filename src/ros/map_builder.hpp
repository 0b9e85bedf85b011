// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/localizer/localizer.hpp"
#include "core/background.hpp"
#include "node_options.hpp"

namespace adaptive_localization {

/// A map, and what was prepared of it for the localizer, if it was.
struct BuiltMap {
  Ground ground;
  bool is_updated{false};  // one that was there before, with other cells
  std::shared_ptr<PreparedMap> prepared{};
};

/// Makes maps from messages. What takes long on a huge map can be done in a thread of its own,
/// while scans are used and transforms sent as before.
class MapBuilder {
 public:
  /// Called in ROS's thread. Throws std::invalid_argument if the map cannot be used.
  using User = std::function<void(BuiltMap&)>;

  /// What is to be done besides in the thread where a map is built; asked for in ROS's thread.
  using Work = std::function<void(BuiltMap&)>;

  /// Updates wait while the user is busy with the last map.
  MapBuilder(ros::NodeHandle node, const NodeOptions& options, User user,
             std::function<Work()> preparation, std::function<bool()> is_busy);

  /// Gives the map to the user, now or, if it need not `wait`, as soon as it is built. The newest
  /// counts: what is still being built before it is given up. The message's cells become the map's.
  /// False, and an error in the log, if the map cannot be used.
  bool build(nav_msgs::OccupancyGrid&& message, bool wait);

  /// Gives the newest map to the user again, with these cells in it, as soon as that is built; what
  /// comes meanwhile is one update. Throws std::invalid_argument if it does not fit into the map.
  void update(const map_msgs::OccupancyGridUpdate& message);

 private:
  using Grid = std::shared_ptr<const OccupancyGrid>;
  bool use(Outcome<BuiltMap> map);
  bool refuse(const std::string& why);
  void giveUp();
  void start(Grid grid);
  void startUpdate();
  void poll();

  const NodeOptions& options_;
  User user_;
  std::function<Work()> preparation_;
  std::function<bool()> is_busy_;
  Ground used_;                    // by the user
  Grid newest_;                    // what updates are of
  std::vector<MapPatch> patches_;  // of that, to be used
  Background<BuiltMap> running_;
  bool is_wanted_{false};  // what is running
  bool is_update_{false};  // what is running
  Grid next_;              // came while another was being built
  std::string refusal_;    // said last
  ros::WallTime refused_;  // when
  ros::WallTimer timer_;
};

}  // namespace adaptive_localization
