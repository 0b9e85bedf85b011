// SPDX-License-Identifier: BSD-3-Clause
#include "bag_log_senses.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/name_list.hpp"

namespace adaptive_localization {
namespace {

const TopicKind kImus{{"sensor_msgs/Imu"}, "option 'imu_topic'", "headings"};
const TopicKind kFields{{"sensor_msgs/MagneticField"}, "option 'magnetic_field_topic'", "headings"};
const TopicKind kHeadings{
    {"geometry_msgs/QuaternionStamped"}, "option 'heading_topic'", "headings"};
const TopicKind kSonars{{"sensor_msgs/Range", "sensor_msgs/PointCloud", "p2os_msgs/SonarArray"},
                        "option 'sonar_topics'",
                        "sonars"};
const TopicKind kLandmarks{{"sensor_msgs/PointCloud"}, "option 'landmark_topic'", "landmarks"};

}  // namespace

/// The scans of a recording and its odometry, by stamps.
class BagSenses::ScansInTime {
 public:
  explicit ScansInTime(std::vector<LogScan>& scans) {
    std::vector<StampedPose> poses;
    for (LogScan& scan : scans) {
      scans_.push_back(&scan);
      poses.push_back({scan.scan.stamp, scan.T_odom_base});
    }
    std::stable_sort(scans_.begin(), scans_.end(), [](const LogScan* a, const LogScan* b) {
      return a->scan.stamp < b->scan.stamp;
    });
    odometry_ = Trajectory(std::move(poses));
  }

  /// The first scan at or after a stamp, with where base then was as seen from where it is by that
  /// scan; null where there is none, or no odometry.
  std::pair<LogScan*, Pose2> nextAfter(double stamp) const {
    constexpr double kLongestGap = 1.0;  // s
    const auto T_odom_then = odometry_.at(stamp, kLongestGap);
    const auto scan = std::lower_bound(
        scans_.begin(), scans_.end(), stamp,
        [](const LogScan* one, double wanted) { return one->scan.stamp < wanted; });
    if (!T_odom_then || scan == scans_.end()) return {nullptr, {}};
    return {*scan, between((*scan)->T_odom_base, *T_odom_then)};
  }

 private:
  std::vector<LogScan*> scans_;
  Trajectory odometry_;
};

BagSenses::BagSenses(const LogRequest& request, const BagFrames& frames)
    : request_(request),
      frames_(frames),
      headings_(
          request.headings,
          [this](const std::string& frame) -> Eigen::Matrix3d {
            return frames_.placeOf(frame).linear();
          },
          [this](const std::string& sense, const std::string& why) { complain(sense, why); }),
      sonars_(
          request.sonars, [this](const std::string& frame) { return frames_.placeOf(frame); },
          [this](const std::string& why) { complain("sonars", why); }),
      landmarks_(request.landmarks, request.landmark_map,
                 [this](const std::string& why) { complain("landmarks", why); }) {
  headings_.history() = HeadingHistory(std::numeric_limits<double>::infinity());
}

std::vector<std::string> BagSenses::faultsOf(const TopicTypes& types) const {
  std::vector<std::string> faults;
  const auto check = [&](const std::string& topic, const TopicKind& kind) {
    const std::string fault = topic.empty() ? "" : faultOf(topic, kind, types);
    if (!fault.empty()) faults.push_back(fault);
  };
  check(request_.headings.imu_topic, kImus);
  check(request_.headings.magnetic_field_topic, kFields);
  check(request_.headings.heading_topic, kHeadings);
  for (const auto& topic : namesIn(request_.sonars.sonar_topics)) check(topic, kSonars);
  check(request_.landmarks.landmark_topic, kLandmarks);
  return faults;
}

void BagSenses::hear(const BagMessage& message) {
  headings_.hear(message);
  if (auto round = sonars_.hear(message)) rounds_.push_back(std::move(*round));
  if (!landmarks_.listensTo(message.topic)) return;
  if (auto cloud = message.as<sensor_msgs::PointCloud>()) {
    const std::string frame = withoutLeadingSlash(cloud->header.frame_id);
    clouds_.push_back({std::move(*cloud), outcomeOf([&] { return frames_.placeOf(frame); })});
  }
}

void BagSenses::addTo(std::vector<LogScan>& scans) {
  for (LogScan& scan : scans) addHeading(scan);
  const ScansInTime scans_in_time(scans);
  addSonars(scans_in_time);
  addLandmarks(scans_in_time);
}

void BagSenses::addHeading(LogScan& scan) const {
  if (const auto reading = headings_.history().headingAt(scan.scan.stamp)) {
    scan.heading = reading->heading;
  }
  scan.gyro = headings_.history().turnAt(scan.scan.stamp);
}

/// What sonars heard between two scans is told with the second one, from where the robot is then.
void BagSenses::addSonars(const ScansInTime& scans) const {
  for (const SonarRound& round : rounds_) {
    const auto [scan, T_now_then] = scans.nextAfter(round.stamp);
    if (!scan) continue;
    for (SonarReading reading : round.readings) {
      reading.T_base_sonar = T_now_then * reading.T_base_sonar;
      scan->sonar.push_back(reading);
    }
  }
}

/// Of the pictures between two scans the last one is told with the second scan, as by the node.
void BagSenses::addLandmarks(const ScansInTime& scans) {
  std::map<LogScan*, std::pair<Pose2, Picture>> newest;
  for (const Cloud& cloud : clouds_) {
    if (!landmarks_.accept(cloud.message)) continue;
    const auto [scan, T_now_then] = scans.nextAfter(cloud.message.header.stamp.toSec());
    if (!cloud.T_base_sensor.value) {
      landmarks_.drop(cloud.T_base_sensor.error);
    } else if (scan) {
      auto picture = landmarks_.read(cloud.message, *cloud.T_base_sensor.value);
      if (picture) newest[scan] = {T_now_then, std::move(*picture)};
    }
  }
  for (const auto& [scan, seen] : newest) {
    tell(seen.second, seen.first, scan->scan.stamp, scan->landmarks);
  }
}

/// The first one of a sense is kept.
void BagSenses::complain(const std::string& sense, const std::string& why) {
  complaints_.insert({sense, why});
}

std::vector<std::string> BagSenses::warnings() const {
  std::vector<std::string> warnings;
  const auto warnOf = [&](const std::string& sense, const Heard& heard) {
    if (heard.dropped == 0) return;
    warnings.push_back("messages of the " + sense + " dropped: " + std::to_string(heard.dropped) +
                       " of " + std::to_string(heard.received) +
                       "; the first: " + complaints_.at(sense));
  };
  warnOf("compass", headings_.headings());
  warnOf("gyroscope", headings_.rates());
  warnOf("sonars", sonars_.heard());
  warnOf("landmarks", landmarks_.heard());
  return warnings;
}

}  // namespace adaptive_localization
