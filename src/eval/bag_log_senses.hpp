// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud.h>

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "../bag/heading_ear.hpp"
#include "../bag/sighting_ear.hpp"
#include "../bag/sonar_ear.hpp"
#include "bag_log_frames.hpp"
#include "bag_log_topics.hpp"
#include "core/background.hpp"
#include "eval/log.hpp"

namespace adaptive_localization {

/// What other senses than the laser tell in a bag, as its messages come by in the order of
/// recording: compass, gyroscope, sonars, landmarks.
class BagSenses {
 public:
  /// Throws std::invalid_argument naming the option that does not fit.
  BagSenses(const LogRequest& request, const BagFrames& frames);

  /// A topic that is wanted and that the bag does not have is a slip, as a parameter that nobody
  /// knows.
  std::vector<std::string> faultsOf(const TopicTypes& types) const;

  void hear(const BagMessage& message);

  /// Tells each scan what was heard by its stamp, after the last message.
  void addTo(std::vector<LogScan>& scans);

  /// What was dropped, in words.
  std::vector<std::string> warnings() const;

 private:
  /// Sightings, and where their sensor sat when they were heard.
  struct Cloud {
    sensor_msgs::PointCloud message;
    Outcome<Eigen::Isometry3d> T_base_sensor;
  };
  class ScansInTime;

  void addHeading(LogScan& scan) const;
  void addSonars(const ScansInTime& scans) const;
  void addLandmarks(const ScansInTime& scans);
  void complain(const std::string& sense, const std::string& why);

  const LogRequest& request_;
  const BagFrames& frames_;
  HeadingEar headings_;
  SonarEar sonars_;
  SightingEar landmarks_;
  std::vector<SonarRound> rounds_;
  std::vector<Cloud> clouds_;
  std::map<std::string, std::string> complaints_;  // of each sense, the first
};

}  // namespace adaptive_localization
