// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// Where landmarks are sighted, live or in a bag.
struct LandmarkTopics {
  std::string landmark_topic;
  double reflector_intensity{0.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("landmark_topic", landmark_topic, Choices{},
           "Topic with sightings of the landmark_map's landmarks (sensor_msgs/PointCloud); empty: "
           "none.");
    option("reflector_intensity", reflector_intensity, kNotNegative, "",
           "What is at least so bright in a scan is a landmark of the landmark_map that is not "
           "identified; 0: scans have none.");
  }
};

}  // namespace adaptive_localization
