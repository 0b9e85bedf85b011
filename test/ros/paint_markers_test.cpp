// SPDX-License-Identifier: BSD-3-Clause
#include "ros/paint_markers.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace adaptive_localization {
namespace {

using testing::SizeIs;
using visualization_msgs::Marker;

Paint field() {
  Paint paint;
  paint.line_width = 0.1;
  paint.lines = {{{0, 0}, {3, 0}}, {{3, 0}, {3, 2}}};
  paint.carpet = Bounds{{-1, -1}, {5, 3}};
  return paint;
}

std_msgs::Header inMap() {
  std_msgs::Header header;
  header.frame_id = "map";
  return header;
}

/// Of its triangles, m^2.
double areaOf(const Marker& marker) {
  double area = 0.0;
  for (std::size_t i = 2; i < marker.points.size(); i += 3) {
    const auto &a = marker.points[i - 2], &b = marker.points[i - 1], &c = marker.points[i];
    area += std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2.0;
  }
  return area;
}

TEST(PaintMarkers, AreTheCarpetAndLinesAsWideAsTheyArePainted) {
  const auto markers = paintMarkers(inMap(), field()).markers;
  ASSERT_THAT(markers, SizeIs(2));
  const Marker &carpet = markers[0], &lines = markers[1];
  EXPECT_EQ(carpet.header.frame_id, "map");
  EXPECT_EQ(carpet.type, Marker::CUBE);
  EXPECT_EQ(carpet.pose.position.x, 2.0);
  EXPECT_EQ(carpet.pose.position.y, 1.0);
  EXPECT_EQ(carpet.scale.x, 6.0);
  EXPECT_EQ(carpet.scale.y, 4.0);
  EXPECT_EQ(lines.type, Marker::TRIANGLE_LIST);
  EXPECT_NE(lines.id, carpet.id);
  // each line reaches half its width beyond its ends
  EXPECT_NEAR(areaOf(lines), 0.1 * (3.1 + 2.1), 1e-9);
  for (const auto& point : lines.points) {
    EXPECT_GT(point.z, carpet.pose.position.z + carpet.scale.z / 2.0);
    EXPECT_LT(point.z, 0.0) << "below what else is shown";
  }
}

TEST(PaintMarkers, AreOfWhatThereIs) {
  Paint paint = field();
  paint.carpet.reset();
  ASSERT_THAT(paintMarkers(inMap(), paint).markers, SizeIs(1));
  EXPECT_EQ(paintMarkers(inMap(), paint).markers[0].type, Marker::TRIANGLE_LIST);
  EXPECT_THAT(paintMarkers(inMap(), {}).markers, SizeIs(0));
}

}  // namespace
}  // namespace adaptive_localization
