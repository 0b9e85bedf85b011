// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "core/heading_topics.hpp"
#include "core/landmark_topics.hpp"
#include "core/sonar_topics.hpp"
#include "eval/trajectory.hpp"
#include "map/landmark_map.hpp"

namespace adaptive_localization {

/// One scan of a recording with all that was known at its stamp.
struct LogScan {
  LaserScan scan;
  LaserMount mount;
  Pose2 T_odom_base;
  std::optional<Pose2> T_map_base;                   // the reference, where the recording has one
  std::optional<Heading> heading{};                  // of a compass, where the recording has one
  std::optional<GyroTurn> gyro{};                    // and of a gyroscope
  std::vector<SonarReading> sonar{};                 // since the scan before, where it has sonars
  std::optional<std::vector<Sighting>> landmarks{};  // sighted last, where it has landmarks
};

/// A recording as plain values, in the order in which it was recorded.
struct Log {
  std::vector<LogScan> scans;
  std::vector<std::string> warnings;  // what was wrong with the recording, in words
  int skipped{0};                     // broken lines, scans without odometry
};

/// Names of the frames in a bag; amcl's keys.
struct FrameOptions {
  std::string odom_frame_id{"odom"};
  std::string base_frame_id{"base_link"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("odom_frame_id", odom_frame_id, Choices{}, "Frame of the odometry.");
    option("base_frame_id", base_frame_id, Choices{}, "Frame of the robot.");
  }
};

/// What to take from a recording.
struct LogRequest {
  std::string file;
  double begin{-std::numeric_limits<double>::infinity()};  // stamps of the log, s
  double end{std::numeric_limits<double>::infinity()};
  std::string scan_topic;   // empty: the only one with laser scans
  std::string odom_topic;   // empty: /tf, else the only one with odometry
  std::string truth_topic;  // empty: no reference from the bag
  FrameOptions frames;
  HeadingTopics headings;
  SonarTopics sonars;
  LandmarkTopics landmarks;
  bool has_intensities{false};  // whether scans shall have those of the recording
  LandmarkMap landmark_map;     // those that may be sighted
};

/// Whether a stamp lies within begin and end, to the microsecond that text gives them with.
inline bool isWanted(double stamp, const LogRequest& request) {
  constexpr double kRounding = 1e-6;  // s
  return stamp >= request.begin - kRounding && stamp <= request.end + kRounding;
}

/// Sets the reference of each scan from a trajectory. Within a gap of more than a second there is
/// none.
inline void setReference(const Trajectory& reference, Log& log) {
  constexpr double kLongestGap = 1.0;  // s
  for (auto& scan : log.scans) scan.T_map_base = reference.at(scan.scan.stamp, kLongestGap);
}

}  // namespace adaptive_localization
