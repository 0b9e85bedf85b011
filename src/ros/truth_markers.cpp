// SPDX-License-Identifier: BSD-3-Clause
#include "truth_markers.hpp"

#include "marker.hpp"
#include "sim/people.hpp"

namespace adaptive_localization {
namespace {

using visualization_msgs::Marker;

Marker marker(const std_msgs::Header& header, const char* name, int id, int type,
              const Pose2& T_map_marker) {
  Marker marker = makeMarker(header, name, id, type, T_map_marker);
  marker.lifetime = ros::Duration(2.0);
  return marker;
}

void shape(Marker& marker, double x, double y, double z, double height) {
  marker.scale.x = x;
  marker.scale.y = y;
  marker.scale.z = z;
  marker.pose.position.z = height;
}

}  // namespace

visualization_msgs::MarkerArray truthMarkers(const std_msgs::Header& header,
                                             const Pose2& T_map_base,
                                             const std::vector<Eigen::Vector2d>& people) {
  constexpr double kRobotRadius = 0.25;  // m, as ARIA has it
  visualization_msgs::MarkerArray array;
  Marker disc = marker(header, "truth", 0, Marker::CYLINDER, T_map_base);
  shape(disc, 2.0 * kRobotRadius, 2.0 * kRobotRadius, 0.05, 0.025);
  disc.color = colour(0.1F, 0.7F, 0.2F, 0.6F);
  Marker arrow = marker(header, "truth", 1, Marker::ARROW, T_map_base);
  shape(arrow, 0.5, 0.06, 0.06, 0.35);
  arrow.color = colour(0.1F, 0.7F, 0.2F, 1.0F);
  array.markers = {disc, arrow};
  for (const auto& person : people) {
    const int id = static_cast<int>(array.markers.size());
    Marker column = marker(header, "people", id, Marker::CYLINDER, {person.x(), person.y(), 0.0});
    shape(column, 2.0 * People::kRadius, 2.0 * People::kRadius, 1.7, 0.85);
    column.color = colour(0.9F, 0.5F, 0.1F, 0.7F);
    array.markers.push_back(column);
  }
  return array;
}

}  // namespace adaptive_localization
