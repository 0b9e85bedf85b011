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
  for (const auto& [name, frame] : frames_) {
    if (frame.fought.isZero() || now - frame.fought > kRemembered) continue;
    text += (text.empty() ? "'" : "; '") + name + "' is published by " +
            std::min(frame.last.publisher, frame.other.publisher) + " and by " +
            std::max(frame.last.publisher, frame.other.publisher);
  }
  return text;
}

}  // namespace adaptive_localization
