// SPDX-License-Identifier: BSD-3-Clause
#include "landmark_markers.hpp"

#include <cmath>

#include "marker.hpp"

namespace adaptive_localization {
namespace {

using visualization_msgs::Marker;

geometry_msgs::Point toPoint(const Eigen::Vector2d& place) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  point.z = 0.2;
  return point;
}

}  // namespace

visualization_msgs::MarkerArray landmarkMarkers(const std_msgs::Header& header,
                                                const LandmarkMap& known, const Pose2& T_map_base,
                                                const std::vector<Sighting>& sightings) {
  Marker posts = makeMarker(header, "landmarks", 0, Marker::SPHERE_LIST);
  posts.color = colour(kKnownLandmark);
  posts.scale.x = posts.scale.y = posts.scale.z = 0.2;
  for (const Landmark& landmark : known.all()) posts.points.push_back(toPoint(landmark.place));
  Marker lines = makeMarker(header, "landmarks", 1, Marker::LINE_LIST);
  lines.color = colour(kLandmarkSighting);
  lines.scale.x = 0.03;
  if (sightings.empty()) lines.action = Marker::DELETE;
  for (const Sighting& sighting : sightings) {
    const Eigen::Vector2d point =
        sighting.range * Eigen::Vector2d(std::cos(sighting.bearing), std::sin(sighting.bearing));
    lines.points.push_back(toPoint({T_map_base.x, T_map_base.y}));
    lines.points.push_back(toPoint(T_map_base * point));
  }
  visualization_msgs::MarkerArray array;
  array.markers = {posts, lines};
  return array;
}

}  // namespace adaptive_localization
