// SPDX-License-Identifier: BSD-3-Clause
#include "display.hpp"

#include <visualization_msgs/MarkerArray.h>

#include "landmark_markers.hpp"
#include "point_markers.hpp"
#include "ser/places.hpp"
#include "status_markers.hpp"

namespace adaptive_localization {
namespace {

const ros::WallDuration kPeriod(0.2);
constexpr std::size_t kMostPoints = 20000;

}  // namespace

Display::Display(ros::NodeHandle private_node, const NodeOptions& options)
    : options_(options),
      ser_(private_node.advertise<visualization_msgs::Marker>("ser", 1)),
      match_(private_node.advertise<visualization_msgs::Marker>("match", 1)),
      text_(private_node.advertise<visualization_msgs::MarkerArray>("status_text", 1)),
      landmarks_(private_node.advertise<visualization_msgs::MarkerArray>("landmarks", 1)) {}

void Display::showLandmarks(const LandmarkMap& known, const Pose2& T_map_base,
                            const std::vector<Sighting>& sightings, const ros::Time& stamp) {
  if (landmarks_.getNumSubscribers() == 0) return;
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = options_.global_frame_id;
  landmarks_.publish(landmarkMarkers(header, known, T_map_base, sightings));
}

void Display::show(const Localization& answer, const Scan& scan, const Match* match, Places& places,
                   const ros::Time& stamp) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = options_.global_frame_id;
  if (answer.updated) showMatch(scan, match, header);
  const auto now = ros::WallTime::now();
  if (now - shown_ < kPeriod) return;
  if (text_.getNumSubscribers() > 0) {
    text_.publish(statusMarkers(header, answer, match));
    shown_ = now;
  }
  const auto grid = ser_.getNumSubscribers() > 0 ? places.energyGrid(scan) : nullptr;
  if (!grid) return;
  ser_.publish(serMarker(header, *grid, scan, kMostPoints));
  shown_ = now;
}

void Display::showMatch(const Scan& scan, const Match* match, const std_msgs::Header& header) {
  const auto now = ros::WallTime::now();
  if (match_.getNumSubscribers() == 0 || now - match_shown_ < kPeriod) return;
  match_.publish(matchMarker(header, match, scan));
  match_shown_ = now;
}

}  // namespace adaptive_localization
