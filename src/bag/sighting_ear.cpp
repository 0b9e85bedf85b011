// SPDX-License-Identifier: BSD-3-Clause
#include "sighting_ear.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "names.hpp"
#include "sighting_messages.hpp"
#include "stamps.hpp"

namespace adaptive_localization {
namespace {

Sighting seenFrom(const Pose2& T_now_then, Sighting sighting) {
  const Eigen::Vector2d point =
      T_now_then * Eigen::Vector2d(sighting.range * std::cos(sighting.bearing),
                                   sighting.range * std::sin(sighting.bearing));
  sighting.range = point.norm();
  sighting.bearing = std::atan2(point.y(), point.x());
  return sighting;
}

}  // namespace

void tell(const Picture& picture, const Pose2& T_now_then, double now,
          std::optional<std::vector<Sighting>>& landmarks) {
  constexpr double kOld = 0.5;  // s
  if (std::abs(now - picture.stamp) > kOld) return;
  if (!landmarks) landmarks.emplace();
  for (const Sighting& sighting : picture.sightings) {
    landmarks->push_back(seenFrom(T_now_then, sighting));
  }
}

SightingEar::SightingEar(const LandmarkTopics& topics, LandmarkMap known, Complain complain)
    : topics_(topics), known_(std::move(known)), complain_(std::move(complain)) {
  if (topics.landmark_topic.empty() || !known_.all().empty()) return;
  throw std::invalid_argument("option 'landmark_topic': got '" + topics.landmark_topic +
                              "' without a landmark_map, expected both");
}

bool SightingEar::listensTo(const std::string& topic) const {
  const std::string& wanted = topics_.landmark_topic;
  return !wanted.empty() && withoutLeadingSlash(topic) == withoutLeadingSlash(wanted);
}

bool SightingEar::accept(const sensor_msgs::PointCloud& message) {
  ++heard_.received;
  const std::string fault = faultOf(message);
  if (!fault.empty()) drop(fault);
  return fault.empty();
}

/// Empty for none.
std::string SightingEar::faultOf(const sensor_msgs::PointCloud& message) const {
  const std::string frame = withoutLeadingSlash(message.header.frame_id);
  if (frame.empty()) return "its frame_id is empty";
  if (!leavesRoom(message.header.stamp)) return "its stamp is out of range";
  const auto last = last_.find(frame);
  const bool is_next = last == last_.end() || message.header.stamp > last->second;
  return is_next ? "" : "its stamp does not come after the last one";
}

std::optional<Picture> SightingEar::read(const sensor_msgs::PointCloud& message,
                                         const Eigen::Isometry3d& T_base_sensor) {
  bool is_whole = true;
  const auto refuse = [&](const std::string& why) {
    if (std::exchange(is_whole, false)) ++heard_.dropped;
    complain_(why);
  };
  Picture picture{message.header.stamp.toSec(), {}};
  try {
    for (const Sighting& sighting : toSightings(message, T_base_sensor, refuse)) {
      if (!known_.candidates(sighting.id).empty()) {
        picture.sightings.push_back(sighting);
      } else {
        refuse("id of a landmark: got " + std::to_string(sighting.id) +
               ", which is not in the map");
      }
    }
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
    return std::nullopt;
  }
  last_[withoutLeadingSlash(message.header.frame_id)] = message.header.stamp;
  return picture;
}

ros::Time SightingEar::last() const {
  ros::Time newest;
  for (const auto& [frame, stamp] : last_) newest = std::max(newest, stamp);
  return newest;
}

void SightingEar::drop(const std::string& why) {
  ++heard_.dropped;
  complain_(why);
}

}  // namespace adaptive_localization
