// SPDX-License-Identifier: BSD-3-Clause
#include "paint_markers.hpp"

#include "marker.hpp"

namespace adaptive_localization {
namespace {

using visualization_msgs::Marker;

constexpr double kCarpet = -0.02, kLines = -0.01;  // m, heights

Marker carpetMarker(const std_msgs::Header& header, const Bounds& carpet) {
  constexpr double kThick = 0.01;  // m
  const Eigen::Vector2d middle = (carpet.low + carpet.high) / 2.0;
  const Eigen::Vector2d size = carpet.high - carpet.low;
  Marker cube = makeMarker(header, "paint", 0, Marker::CUBE, {middle.x(), middle.y(), 0.0});
  cube.color = colour(0.35F, 0.65F, 0.35F);
  cube.pose.position.z = kCarpet - kThick / 2.0;
  cube.scale.x = size.x();
  cube.scale.y = size.y();
  cube.scale.z = kThick;
  return cube;
}

Marker lineMarker(const std_msgs::Header& header, const Paint& paint) {
  Marker triangles = makeMarker(header, "paint", 1, Marker::TRIANGLE_LIST);
  triangles.color = colour(1.0F, 1.0F, 1.0F);
  triangles.scale.x = triangles.scale.y = triangles.scale.z = 1.0;
  for (const Segment& line : paint.lines) {
    const Polygon corners = thickLine(line, paint.line_width);
    for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
      geometry_msgs::Point point;
      point.x = corners[corner].x();
      point.y = corners[corner].y();
      point.z = kLines;
      triangles.points.push_back(point);
    }
  }
  return triangles;
}

}  // namespace

visualization_msgs::MarkerArray paintMarkers(const std_msgs::Header& header, const Paint& paint) {
  visualization_msgs::MarkerArray array;
  if (paint.carpet) array.markers.push_back(carpetMarker(header, *paint.carpet));
  if (!paint.lines.empty()) array.markers.push_back(lineMarker(header, paint));
  return array;
}

}  // namespace adaptive_localization
