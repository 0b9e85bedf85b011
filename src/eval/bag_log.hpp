// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/log.hpp"

namespace adaptive_localization {

/// Reads a rosbag. Odometry at each scan's stamp and the laser's mount come from /tf and
/// /tf_static; where /tf has no odometry, from a nav_msgs/Odometry topic, also when
/// request.odom_topic names it. Static transforms count whenever they were recorded. The reference
/// is a topic of PoseStamped, PoseWithCovarianceStamped or Odometry. Broken messages are skipped
/// and counted. Other senses are heard on the topics of request.headings, sonars and landmarks, as
/// the node hears them; each scan has what they told by its stamp, from where the robot is by then.
/// Of sightings of landmarks the last one counts that is not older than half a second.
///
/// Throws std::invalid_argument naming the bag and what is wrong with it. A bag that was cut off or
/// never closed has no index and is rejected.
Log readBagLog(const LogRequest& request);

}  // namespace adaptive_localization
