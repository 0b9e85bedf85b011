// SPDX-License-Identifier: BSD-3-Clause
#include "eval/bag_log.hpp"

#include <console_bridge/console.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "../bag/bag_stream.hpp"
#include "bag_log_frames.hpp"
#include "bag_log_senses.hpp"
#include "bag_log_topics.hpp"
#include "core/sweep_watch.hpp"

namespace adaptive_localization {
namespace {

const TopicKind kScans{{"sensor_msgs/LaserScan"}, "--scan-topic", "laser scans"};
const TopicKind kOdometry{{"nav_msgs/Odometry"}, "--odom-topic", "odometry"};
const TopicKind kReference{
    {"geometry_msgs/PoseStamped", "geometry_msgs/PoseWithCovarianceStamped", "nav_msgs/Odometry"},
    "--truth-topic",
    "poses"};

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
        frames_(request.frames, request.has_intensities),
        senses_(request, frames_) {}

  Log read() {
    scan_topic_ = choose(request_.scan_topic, kScans, types_);
    if (!request_.odom_topic.empty() || topicsOf(kOdometry, types_).size() == 1) {
      odom_topic_ = choose(request_.odom_topic, kOdometry, types_);
    }
    if (!request_.truth_topic.empty()) {
      truth_topic_ = choose(request_.truth_topic, kReference, types_);
    }
    warn(senses_.faultsOf(types_));
    readMessages();
    takeScans();
    senses_.addTo(log_.scans);
    warn(senses_.warnings());
    if (!truth_topic_.empty()) setReference(Trajectory(std::move(reference_)), log_);
    return std::move(log_);
  }

 private:
  /// A message that cannot be decoded is skipped; a file that cannot be read on ends the reading.
  void readMessages() {
    while (const auto message = stream_.next()) {
      if (isOfUse(message->topic)) take(*message);
      if (!message->is_broken) senses_.hear(*message);
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

  void warn(const std::vector<std::string>& warnings) {
    log_.warnings.insert(log_.warnings.end(), warnings.begin(), warnings.end());
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

  /// Sweeps that cannot have taken so long are not undone.
  void checkSweeps(std::vector<BagFrames::PlacedScan>& placed) {
    SweepWatch sweeps;
    int count = 0;
    for (auto& [scan, frame, has_odometry, has_mount] : placed) {
      if (sweeps.isPossible(frame, scan.scan)) continue;
      scan.scan.time_increment = 0.0;
      ++count;
    }
    if (count == 0) return;
    log_.warnings.push_back(
        "scans whose time_increment, taken for 0, makes a sweep longer than the time between "
        "scans: " +
        std::to_string(count));
  }

  void takeScans() {
    auto placed = frames_.finish();
    checkSweeps(placed);
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
      if (!scan.has_odometry) {
        ++without_odometry;
        continue;
      }
      log_.scans.push_back(std::move(scan.scan));
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
  const TopicTypes& types_;
  BagFrames frames_;
  BagSenses senses_;
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
