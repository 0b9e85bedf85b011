// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// Where sonars are heard, live or in a bag, and what their messages may not tell.
struct SonarTopics {
  std::string sonar_topics;
  std::string sonar_frame_prefix{"sonar_"};
  double sonar_view{0.524};
  double sonar_max_range{5.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("sonar_topics", sonar_topics, Choices{},
           "Topics with readings of sonars, separated by spaces or commas: sensor_msgs/Range, "
           "ROSARIA's sensor_msgs/PointCloud or p2os_msgs/SonarArray; empty: none.");
    option("sonar_frame_prefix", sonar_frame_prefix, Choices{},
           "Prefix of the tf frames of sonars that share a message: reading i, from 0, has the "
           "frame with this prefix and i, whose x is the axis of the cone.");
    option("sonar_view", sonar_view, Range{0.01, kPi}, "rad",
           "Opening angle of a sonar's cone, where the message does not say.");
    option("sonar_max_range", sonar_max_range, Range{0.1, 100}, "m",
           "Largest range of a sonar, where the message does not say.");
  }
};

}  // namespace adaptive_localization
