// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/bag_log.hpp"

#include <console_bridge/console.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "../bag/bag_stream.hpp"
#include "../bag/heading_ear.hpp"
#include "../bag/sonar_ear.hpp"
#include "adaptive_localization/core/name_list.hpp"
#include "bag_log_frames.hpp"

namespace adaptive_localization {
namespace {

/// What a choice of topic is for: the message types that fit, the argument that names one, a word.
struct TopicKind {
  std::set<std::string> types;
  std::string argument;
  std::string what;
};

const TopicKind kScans{{"sensor_msgs/LaserScan"}, "--scan-topic", "laser scans"};
const TopicKind kOdometry{{"nav_msgs/Odometry"}, "--odom-topic", "odometry"};
const TopicKind kReference{
    {"geometry_msgs/PoseStamped", "geometry_msgs/PoseWithCovarianceStamped", "nav_msgs/Odometry"},
    "--truth-topic",
    "poses"};

/// a, b, c; "none" for no words.
std::string join(const std::set<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none" : text;
}

using Types = std::map<std::string, std::string>;  // of messages, by topic

/// Names of the topics whose type fits.
std::set<std::string> topicsOf(const TopicKind& kind, const Types& types) {
  std::set<std::string> names;
  for (const auto& [topic, type] : types) {
    if (kind.types.count(type)) names.insert(topic);
  }
  return names;
}

/// The topic that `wanted` names, or, if it is empty, the only one that fits; the slash in front
/// does not matter. Throws std::invalid_argument naming the topics there are.
std::string choose(const std::string& wanted, const TopicKind& kind, const Types& types) {
  const auto candidates = topicsOf(kind, types);
  if (wanted.empty()) {
    if (candidates.size() == 1) return *candidates.begin();
    if (candidates.empty()) throw std::invalid_argument("has no topic with " + kind.what);
    throw std::invalid_argument("has several topics with " + kind.what + ", name one with " +
                                kind.argument + ": " + join(candidates));
  }
  for (const auto& topic : candidates) {
    if (withoutLeadingSlash(topic) == withoutLeadingSlash(wanted)) return topic;
  }
  throw std::invalid_argument(kind.argument + ": got '" + wanted + "', expected a topic with " +
                              kind.what + " of this bag: " + join(candidates));
}

StampedPose toStampedPose(const std_msgs::Header& header, const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  const double yaw = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  return {header.stamp.toSec(), {pose.position.x, pose.position.y, wrapAngle(yaw)}};
}

std::optional<StampedPose> toStampedPose(const BagMessage& message) {
  std::optional<StampedPose> pose;
  if (const auto plain = message.as<geometry_msgs::PoseStamped>()) {
    pose = toStampedPose(plain->header, plain->pose);
  } else if (const auto wide = message.as<geometry_msgs::PoseWithCovarianceStamped>()) {
    pose = toStampedPose(wide->header, wide->pose.pose);
  } else if (const auto odometry = message.as<nav_msgs::Odometry>()) {
    pose = toStampedPose(odometry->header, odometry->pose.pose);
  }
  return pose && isFinite(pose->pose) ? pose : std::nullopt;
}

/// Keeps tf from printing a line of their own for each oddity of a recording.
class Silence {
 public:
  Silence() { console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE); }
  ~Silence() { console_bridge::setLogLevel(level_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  console_bridge::LogLevel level_{console_bridge::getLogLevel()};
};

class BagReader {
 public:
  explicit BagReader(const LogRequest& request)
      : request_(request),
        stream_(request.file),
        types_(stream_.types()),
        frames_(request.frames),
        ear_(
            request.headings,
            [this](const std::string& frame) -> Eigen::Matrix3d {
              return frames_.placeOf(frame).linear();
            },
            [this](const std::string& sense, const std::string& why) {
              complaints_.insert({sense, why});
            }),
        sonars_(
            request.sonars, [this](const std::string& frame) { return frames_.placeOf(frame); },
            [this](const std::string& why) {
              complaints_.insert({"sonars", why});
            }) {
    ear_.history() = HeadingHistory(std::numeric_limits<double>::infinity());
  }

  Log read() {
    scan_topic_ = choose(request_.scan_topic, kScans, types_);
    if (!request_.odom_topic.empty() || topicsOf(kOdometry, types_).size() == 1) {
      odom_topic_ = choose(request_.odom_topic, kOdometry, types_);
    }
    if (!request_.truth_topic.empty()) {
      truth_topic_ = choose(request_.truth_topic, kReference, types_);
    }
    checkSenses();
    readMessages();
    warnOfDropped("compass", ear_.headings());
    warnOfDropped("gyroscope", ear_.rates());
    warnOfDropped("sonars", sonars_.heard());
    takeScans();
    for (auto& scan : log_.scans) addHeading(scan);
    addRounds();
    if (!truth_topic_.empty()) setReference(Trajectory(std::move(reference_)), log_);
    return std::move(log_);
  }

 private:
  /// A message that cannot be decoded is skipped; a file that cannot be read on ends the reading.
  void readMessages() {
    while (const auto message = stream_.next()) {
      if (isOfUse(message->topic)) take(*message);
      if (message->is_broken) continue;
      ear_.hear(*message);
      if (auto round = sonars_.hear(*message)) rounds_.push_back(std::move(*round));
    }
    if (!stream_.whyStopped().empty()) {
      log_.warnings.push_back("reading stopped early: " + stream_.whyStopped());
    }
  }

  bool isOfUse(const std::string& topic) const {
    const std::string name = withoutLeadingSlash(topic);
    return name == "tf" || name == "tf_static" || topic == scan_topic_ || topic == odom_topic_ ||
           topic == truth_topic_;
  }

  /// A topic that the bag does not have is a slip, as a parameter that nobody knows.
  void checkSenses() {
    const HeadingTopics& wanted = request_.headings;
    for (const auto& topic :
         {wanted.imu_topic, wanted.magnetic_field_topic, wanted.heading_topic}) {
      if (!topic.empty()) checkTopic(topic, "headings");
    }
    for (const auto& topic : namesIn(request_.sonars.sonar_topics)) checkTopic(topic, "sonars");
  }

  void checkTopic(const std::string& topic, const std::string& what) {
    const bool is_there = std::any_of(types_.begin(), types_.end(), [&](const auto& entry) {
      return withoutLeadingSlash(entry.first) == withoutLeadingSlash(topic);
    });
    if (!is_there)
      log_.warnings.push_back("no topic '" + topic + "' with " + what + " in this bag");
  }

  void addHeading(LogScan& scan) const {
    if (const auto reading = ear_.history().headingAt(scan.scan.stamp)) {
      scan.heading = reading->heading;
    }
    scan.gyro = ear_.history().turnAt(scan.scan.stamp);
  }

  /// What sonars heard between two scans is told with the second one, from where the robot is then.
  void addRounds() {
    constexpr double kLongestGap = 1.0;  // s
    std::vector<StampedPose> poses;
    for (const LogScan& scan : log_.scans) poses.push_back({scan.scan.stamp, scan.T_odom_base});
    const Trajectory odometry(std::move(poses));
    for (const SonarRound& round : rounds_) {
      const auto T_odom_then = odometry.at(round.stamp, kLongestGap);
      const auto scan = std::find_if(log_.scans.begin(), log_.scans.end(), [&](const auto& one) {
        return one.scan.stamp >= round.stamp;
      });
      if (!T_odom_then || scan == log_.scans.end()) continue;
      for (SonarReading reading : round.readings) {
        reading.T_base_sonar = between(scan->T_odom_base, *T_odom_then) * reading.T_base_sonar;
        scan->sonar.push_back(reading);
      }
    }
  }

  void warnOfDropped(const std::string& sense, const Heard& heard) {
    if (heard.dropped == 0) return;
    log_.warnings.push_back("messages of the " + sense +
                            " dropped: " + std::to_string(heard.dropped) + " of " +
                            std::to_string(heard.received) + "; the first: " + complaints_[sense]);
  }

  void take(const BagMessage& message) {
    if (message.is_broken) return skip("a message of " + message.topic + " is broken");
    if (message.topic == scan_topic_) {
      const auto scan = message.as<sensor_msgs::LaserScan>();
      if (scan && isWanted(scan->header.stamp.toSec(), request_)) frames_.add(*scan);
    } else if (const auto tf = message.as<tf2_msgs::TFMessage>()) {
      frames_.add(*tf, message.is_fixed);
    } else if (const auto pose = toStampedPose(message)) {
      if (message.topic == odom_topic_) odometry_.push_back(*pose);
      if (message.topic == truth_topic_) reference_.push_back(*pose);
    }
  }

  void skip(const std::string& why) {
    ++log_.skipped;
    log_.warnings.push_back(why + "; skipped");
  }

  void takeScans() {
    auto placed = frames_.finish();
    const bool has_tf_odometry =
        std::any_of(placed.begin(), placed.end(), [](const auto& p) { return p.has_odometry; });
    if (!request_.odom_topic.empty() || (!has_tf_odometry && !odom_topic_.empty())) {
      const Trajectory odometry(std::move(odometry_));
      for (auto& scan : placed) {
        const auto T_odom_base = odometry.at(scan.scan.scan.stamp);
        scan.has_odometry = T_odom_base.has_value();
        scan.scan.T_odom_base = T_odom_base.value_or(Pose2{});
      }
    } else if (!has_tf_odometry && !placed.empty()) {
      throw std::invalid_argument(
          "has no odometry: no transform from '" + request_.frames.odom_frame_id + "' to '" +
          request_.frames.base_frame_id +
          "' at any scan; topics with odometry: " + join(topicsOf(kOdometry, types_)));
    }
    keepUsable(std::move(placed));
  }

  void keepUsable(std::vector<BagFrames::PlacedScan> placed) {
    std::set<std::string> unknown_frames;
    int without_odometry = 0;
    for (auto& scan : placed) {
      if (!scan.has_mount) unknown_frames.insert(scan.frame);
      if (scan.has_odometry) log_.scans.push_back(std::move(scan.scan));
      if (!scan.has_odometry) ++without_odometry;
    }
    if (!unknown_frames.empty()) {
      log_.warnings.push_back("no transform from '" + request_.frames.base_frame_id +
                              "' to the laser's frame " + join(unknown_frames) +
                              "; the laser is taken to sit at the robot's centre");
    }
    const auto warnOf = [this](const std::string& what, int count) {
      if (count > 0) log_.warnings.push_back(what + ": " + std::to_string(count));
    };
    warnOf("transforms ignored, too old, repeated or not numbers", frames_.refused());
    warnOf("scans skipped for want of odometry at their stamps", without_odometry);
    log_.skipped += without_odometry;
  }

  const LogRequest& request_;
  BagStream stream_;
  const Types& types_;
  BagFrames frames_;
  HeadingEar ear_;
  SonarEar sonars_;
  std::vector<SonarRound> rounds_;
  std::map<std::string, std::string> complaints_;  // of each sense, the first
  std::string scan_topic_, odom_topic_, truth_topic_;
  std::vector<StampedPose> odometry_, reference_;
  Log log_;
};

}  // namespace

Log readBagLog(const LogRequest& request) {
  const Silence silence;
  try {
    return BagReader(request).read();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("bag '" + request.file + "' " + error.what());
  }
}

}  // namespace adaptive_localization
