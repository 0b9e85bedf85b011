// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "core/landmark_topics.hpp"
#include "core/picture.hpp"
#include "heading_ear.hpp"
#include "map/landmark_map.hpp"

namespace adaptive_localization {

/// Adds what a picture shows to the landmarks of an instant, `now` in s, as seen from where base is
/// by then. A picture of half a second before tells nothing any more.
void tell(const Picture& picture, const Pose2& T_now_then, double now,
          std::optional<std::vector<Sighting>>& landmarks);

/// Hears sightings of landmarks, by messages live or from a bag. What cannot be used is dropped,
/// counted, and said why. A message waits until it can be placed: first it is accepted, then read.
class SightingEar {
 public:
  using Complain = std::function<void(const std::string& why)>;

  /// Throws std::invalid_argument where there is a topic, but no landmark is known.
  SightingEar(const LandmarkTopics& topics, LandmarkMap known, Complain complain);

  /// Whether this is the topic, with or without the slash in front.
  bool listensTo(const std::string& topic) const;

  /// False for a message without a frame, or whose stamp is out of range or does not come after
  /// that of the last one from this frame that was read: there may be several cameras.
  bool accept(const sensor_msgs::PointCloud& message);

  /// What an accepted message tells of known landmarks; nothing if it makes no sense.
  std::optional<Picture> read(const sensor_msgs::PointCloud& message,
                              const Eigen::Isometry3d& T_base_sensor);

  /// An accepted message that cannot be read.
  void drop(const std::string& why);

  /// Messages, and those of which something was dropped.
  const Heard& heard() const { return heard_; }

  const LandmarkMap& known() const { return known_; }

  /// Stamp of the newest message that was read; zero before there is one.
  ros::Time last() const;

  /// Time jumped back: what was heard is of another time.
  void forget() { last_.clear(); }

 private:
  std::string faultOf(const sensor_msgs::PointCloud& message) const;

  const LandmarkTopics& topics_;  // the owner's, which may change
  LandmarkMap known_;
  Complain complain_;
  Heard heard_;
  std::map<std::string, ros::Time> last_;  // by frame
};

}  // namespace adaptive_localization
