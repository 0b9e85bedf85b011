// SPDX-License-Identifier: BSD-3-Clause
#include "scan_source.hpp"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <stdexcept>
#include <utility>

#include "../bag/stamps.hpp"
#include "callbacks.hpp"
#include "conversions.hpp"
#include "core/background.hpp"

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kQueue = 100;
const ros::WallDuration kPatience(3.0);  // without a scan

// The filter hands on an event's time of receipt as it was given, whatever the clock.

ros::Time toEventTime(const ros::SteadyTime& arrival) {
  return {arrival.sec, arrival.nsec};
}

ros::SteadyTime arrivalOf(const ros::MessageEvent<const sensor_msgs::LaserScan>& event) {
  return {event.getReceiptTime().sec, event.getReceiptTime().nsec};
}

}  // namespace

ScanSource::ScanSource(ros::NodeHandle node, tf2_ros::Buffer& tf, TransformInput& tf_input,
                       const NodeOptions& options, Callback callback, JumpCallback on_jump)
    : tf_(tf),
      tf_input_(tf_input),
      options_(options),
      mounts_(node, tf, options.base_frame_id),
      callback_(std::move(callback)),
      on_jump_(std::move(on_jump)),
      filter_(tf, options.odom_frame_id, kQueue, node),
      arrivals_(*node.getCallbackQueue()) {
  using ScanPtr = sensor_msgs::LaserScan::ConstPtr;
  filter_.registerCallback(boost::function<void(const Event&)>([this](const Event& event) {
    const auto outcome = outcomeOf([&] { return use(event); });
    if (!outcome.value) drop(outcome.error);
  }));
  filter_.registerFailureCallback(
      [this](const ScanPtr& message, tf2_ros::filter_failure_reasons::FilterFailureReason) {
        drop("tf cannot place frame '" + message->header.frame_id + "' in '" +
                 options_.odom_frame_id + "' at its stamp",
             isSettled());
      });
  node.setCallbackQueue(&arrivals_);
  for (const auto& topic : namesIn(options.scan_topics)) {
    subscribers_.push_back(subscribe<sensor_msgs::LaserScan>(
        node, topic, kQueue, [this](const ScanPtr& message) { add(message); }));
  }
}

bool ScanSource::hears(const std::string& topic) const {
  return std::any_of(subscribers_.begin(), subscribers_.end(),
                     [&](const ros::Subscriber& own) { return own.getTopic() == "/" + topic; });
}

void ScanSource::add(const sensor_msgs::LaserScan::ConstPtr& message) {
  last_received_ = ros::WallTime::now();
  if (++counts_.received == 1) first_received_ = last_received_;
  last_frame_ = withoutLeadingSlash(message->header.frame_id);
  if (last_frame_.empty()) return drop("its frame_id is empty");
  if (!leavesRoom(message->header.stamp)) return drop("its stamp is out of range");
  sensor_msgs::LaserScan::ConstPtr scan = message;
  if (options_.timing.scan_time_offset != 0.0) {
    const auto shifted = boost::make_shared<sensor_msgs::LaserScan>(*message);
    try {  // in whole nanoseconds: rounded up by a few, tf would not have the stamp yet
      shifted->header.stamp += ros::Duration(options_.timing.scan_time_offset);
    } catch (const std::runtime_error&) {
      return drop("its stamp is out of range");
    }
    scan = shifted;
  }
  if (const auto jump = stamps_.jumpTo(last_frame_, scan->header.stamp)) {
    onJump(*jump, scan->header.stamp);
  }
  if (mounts_.lookFor(last_frame_) == LaserMounts::Knowledge::kUnknown) {
    return drop("neither tf nor robot_description knows where frame '" + last_frame_ + "' is",
                isSettled());
  }
  const auto held = tf_input_.hold();
  filter_.add(Event(scan, toEventTime(arrivals_.arrival())));
}

void ScanSource::onJump(double seconds, const ros::Time& stamp) {
  if (seconds < 0.0) {
    // The listener empties tf when the clock jumps; without simulated time it sees no jump, and
    // takes all new transforms for outdated ones.
    try {
      const auto newest =
          tf_.lookupTransform(options_.odom_frame_id, options_.base_frame_id, ros::Time(0));
      if (newest.header.stamp.toSec() > stamp.toSec() + 1.0) tf_.clear();
    } catch (const std::runtime_error&) {  // emptied already
    }
    filter_.clear();
  }
  on_jump_(seconds);
}

/// Throws whatever is wrong with the scan.
bool ScanSource::use(const Event& event) {
  const sensor_msgs::LaserScan& message = *event.getMessage();
  std::string why;
  const auto mount =
      mounts_.at(withoutLeadingSlash(message.header.frame_id), message.header.stamp, &why);
  if (!mount) throw std::invalid_argument(why);
  const bool is_used = callback_(message, *mount, arrivalOf(event));
  last_read_ = ros::WallTime::now();
  why_dropped_.clear();
  if (is_used) ++counts_.used;
  return is_used;
}

/// While everything starts, transforms may come later than scans.
bool ScanSource::isSettled() const {
  return counts_.used > 0 || ros::WallTime::now() - first_received_ > kPatience;
}

void ScanSource::complain(const std::string& why) {
  if (complaints_.isDue(why)) ROS_WARN("Scan: %s", why.c_str());
}

void ScanSource::drop(const std::string& why, bool is_said) {
  ++counts_.dropped;
  why_dropped_ = why;
  if (!is_said || !complaints_.isDue(why)) return;
  ROS_WARN("Scan dropped (%d of %d so far): %s", counts_.dropped, counts_.received, why.c_str());
}

std::string ScanSource::missing() const {
  const auto now = ros::WallTime::now();
  if (!hasTopics()) return "";
  if (now - last_received_ > kPatience) {
    std::string topics;
    for (const auto& subscriber : subscribers_) {
      topics += (topics.empty() ? "" : " or ") + subscriber.getTopic();
    }
    return "a scan on " + topics;
  }
  if (now - last_read_ <= kPatience) return "";
  std::string error;
  if (!tf_.canTransform(options_.base_frame_id, last_frame_, ros::Time(0), &error)) {
    return "a transform from '" + last_frame_ + "' to '" + options_.base_frame_id + "' (" + error +
           ")";
  }
  if (!tf_.canTransform(options_.odom_frame_id, options_.base_frame_id, ros::Time(0), &error)) {
    return "a transform from '" + options_.base_frame_id + "' to '" + options_.odom_frame_id +
           "' (" + error + ")";
  }
  if (!why_dropped_.empty()) return "a scan that can be used (the last one: " + why_dropped_ + ")";
  return "a transform from '" + options_.base_frame_id + "' to '" + options_.odom_frame_id +
         "' at the stamps of the scans";
}

}  // namespace adaptive_localization
