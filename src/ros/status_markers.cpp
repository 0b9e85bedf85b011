// SPDX-License-Identifier: BSD-3-Clause
#include "status_markers.hpp"

#include <algorithm>

#include "conversions.hpp"
#include "ser/place.hpp"
#include "status_message.hpp"

namespace adaptive_localization {
namespace {

using visualization_msgs::Marker;

constexpr std::size_t kMost = 20;  // texts

std_msgs::ColorRGBA colourOf(Status status) {
  std_msgs::ColorRGBA colour;
  colour.a = 1.0F;
  colour.r = status == Status::kTracking ? 0.0F : 0.6F;
  colour.g = status == Status::kTracking ? 0.35F : status == Status::kLost ? 0.0F : 0.2F;
  return colour;
}

Marker textAt(const Pose2& T_map_base, const std::string& text) {
  constexpr double kHeight = 0.3;  // m, of a letter
  constexpr double kAside = 0.5;   // m, so that the robot is not hidden
  Marker marker;
  marker.ns = "status";
  marker.type = Marker::TEXT_VIEW_FACING;
  marker.pose = toPoseMessage({T_map_base.x, T_map_base.y + kAside, 0.0});
  marker.pose.position.z = 1.0;  // above all else that is drawn
  marker.scale.z = kHeight;
  marker.text = text;
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray statusMarkers(const std_msgs::Header& header,
                                              const Localization& answer, const Match* match) {
  visualization_msgs::MarkerArray array;
  Marker none;
  none.action = Marker::DELETEALL;
  array.markers.push_back(none);
  if (answer.status == Status::kUninitialised) return array;
  std::string status = toText(answer.status) + print(" %.2f", answer.confidence);
  if (match && isRefusal(match->fault)) status += "\nnot matched: " + toText(match->fault);
  array.markers.push_back(textAt(answer.T_map_base, status));
  const auto& modes = answer.modes;
  for (std::size_t i = 0; i < std::min(modes.size(), kMost); ++i) {
    if (areSamePlace(modes[i].T_map_base, answer.T_map_base)) continue;
    array.markers.push_back(textAt(modes[i].T_map_base, print("or here %.2f", modes[i].mass)));
  }
  for (std::size_t i = 1; i < array.markers.size(); ++i) {
    array.markers[i].header = header;
    array.markers[i].id = static_cast<int>(i);
    array.markers[i].color = colourOf(answer.status);
  }
  return array;
}

}  // namespace adaptive_localization
