// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/Range.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/observations.hpp"
#include "bag_stream.hpp"
#include "core/sonar_topics.hpp"
#include "heading_ear.hpp"
#include "sonar_array.hpp"

namespace adaptive_localization {

/// What sonars heard at one instant, from where base was then.
struct SonarRound {
  double stamp{0.0};  // s
  std::vector<SonarReading> readings;
};

/// Hears sonars, by messages live or from a bag:
///
/// * sensor_msgs/Range, one sonar each, told apart by their frames. Its max_range or more is no
/// echo.
/// * sensor_msgs/PointCloud as ROSARIA sends it: where each echo came from; a point at
///   sonar_max_range is no echo.
/// * p2os_msgs/SonarArray, a range each.
///
/// The last two repeat old values, which are not heard again. What cannot be used is dropped,
/// counted, and said why.
class SonarEar {
 public:
  /// Where a sensor's frame sits on base; throws std::exception saying why if nobody knows.
  using PlaceOf = std::function<Eigen::Isometry3d(const std::string& frame)>;
  using Complain = std::function<void(const std::string& why)>;

  SonarEar(const SonarTopics& topics, PlaceOf place_of, Complain complain)
      : topics_(topics), place_of_(std::move(place_of)), complain_(std::move(complain)) {}

  /// Whether this is one of the topics, with or without the slash in front.
  bool listensTo(const std::string& topic) const;

  /// What a message tells that is new; nothing if it is not on one of the topics.
  std::optional<SonarRound> hear(const BagMessage& message);

  /// Messages, and those of which something was dropped.
  const Heard& heard() const { return heard_; }

  /// Time jumped back: what was heard is of another time.
  void forget();

 private:
  SonarRound roundOf(const BagMessage& message);
  SonarRound roundOf(const sensor_msgs::Range& message);
  SonarRound roundOf(const sensor_msgs::PointCloud& message);
  SonarRound roundOf(const SonarArray& message);
  template <class RangeOf>
  SonarRound roundOfAll(double stamp, std::size_t count, const RangeOf& range_of);
  SonarReading readingAt(int sonar, const Eigen::Isometry3d& T_base_sonar) const;
  bool isNew(int sonar, double range);
  void checkStamp(const std::string& of, double stamp);
  void drop(const std::string& why);

  const SonarTopics& topics_;  // the owner's, which may change
  PlaceOf place_of_;
  Complain complain_;
  Heard heard_;
  bool is_dropped_{false};                // something of this message
  std::map<std::string, double> stamps_;  // the last one of each topic or frame
  std::map<std::string, int> numbers_;    // of the frames of single sonars
  std::map<int, double> ranges_;          // the last one of each sonar
};

}  // namespace adaptive_localization
