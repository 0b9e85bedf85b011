// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// Where landmarks are sighted, live or in a bag.
struct LandmarkTopics {
  std::string landmark_topic;

  template <class Visitor>
  void visit(Visitor&& option) {
    option("landmark_topic", landmark_topic, Choices{},
           "Topic with sightings of the landmark_map's landmarks (sensor_msgs/PointCloud); empty: "
           "none.");
  }
};

}  // namespace adaptive_localization
