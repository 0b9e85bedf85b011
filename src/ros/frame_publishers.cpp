// SPDX-License-Identifier: BSD-3-Clause
#include "frame_publishers.hpp"

#include <algorithm>
#include <utility>

namespace adaptive_localization {

void FramePublishers::hear(const std::string& frame, const std::string& publisher,
                           const ros::SteadyTime& now) {
  const ros::WallDuration kTurn(1.0);
  Frame& seen = frames_[frame];
  if (publisher != seen.last.publisher) {
    std::swap(seen.last, seen.other);
    if (seen.last.publisher == publisher && now - seen.last.heard < kTurn) seen.fought = now;
    seen.last.publisher = publisher;
  }
  seen.last.heard = now;
}

std::string FramePublishers::rivals(const ros::SteadyTime& now) const {
  const ros::WallDuration kRemembered(3.0);
  std::string text;
  const auto isRecent = [&](const ros::SteadyTime& time) {
    return !time.isZero() && now - time <= kRemembered;
  };
  for (const auto& [name, frame] : frames_) {
    const std::string start = (text.empty() ? "'" : "; '") + name + "' is published by ";
    const auto& [last, other] = std::pair(frame.last.publisher, frame.other.publisher);
    if (isRecent(frame.fought)) {
      text += start + std::min(last, other) + " and by " + std::max(last, other);
    } else if (!frame.fixed_by.empty() && frame.fixed_by != last && isRecent(frame.last.heard)) {
      text += start + last + " and, as fixed, by " + frame.fixed_by;
    }
  }
  return text;
}

}  // namespace adaptive_localization
