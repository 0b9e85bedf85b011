// SPDX-License-Identifier: BSD-3-Clause
#include "scan_source.hpp"

#include <stdexcept>
#include <utility>

#include "conversions.hpp"

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kQueue = 100;
constexpr std::size_t kReasonsKept = 100;
const ros::WallDuration kSayAgain(5.0);
const ros::WallDuration kWatchPeriod(15.0);

}  // namespace

ScanSource::ScanSource(ros::NodeHandle node, tf2_ros::Buffer& tf, const std::string& odom_frame,
                       const std::string& base_frame, Callback callback)
    : tf_(tf),
      odom_frame_(odom_frame),
      mounts_(node, tf, base_frame),
      callback_(std::move(callback)),
      filter_(tf, odom_frame, kQueue, node) {
  filter_.registerCallback([this](const sensor_msgs::LaserScan::ConstPtr& m) { onPlaced(m); });
  filter_.registerFailureCallback([this](const sensor_msgs::LaserScan::ConstPtr& message,
                                         tf2_ros::filter_failure_reasons::FilterFailureReason) {
    drop("tf cannot place frame '" + message->header.frame_id + "' in '" + odom_frame_ +
         "' at its stamp");
  });
  subscriber_ = node.subscribe("scan", kQueue, &ScanSource::onMessage, this);
  watchdog_ = node.createWallTimer(kWatchPeriod, [this](const ros::WallTimerEvent&) { watch(); });
}

void ScanSource::onMessage(const sensor_msgs::LaserScan::ConstPtr& message) {
  ++counts_.received;
  last_frame_ = withoutLeadingSlash(message->header.frame_id);
  if (last_frame_.empty()) return drop("its frame_id is empty");
  if (mounts_.lookFor(last_frame_) == LaserMounts::Knowledge::kUnknown) {
    return drop("neither tf nor robot_description knows where frame '" + last_frame_ + "' is");
  }
  filter_.add(message);
}

void ScanSource::onPlaced(const sensor_msgs::LaserScan::ConstPtr& message) {
  std::string why;
  const auto mount =
      mounts_.at(withoutLeadingSlash(message->header.frame_id), message->header.stamp, &why);
  if (!mount) return drop(why);
  try {
    if (callback_(*message, *mount)) ++counts_.used;
  } catch (const std::invalid_argument& error) {
    drop(error.what());
  }
}

void ScanSource::drop(const std::string& why) {
  ++counts_.dropped;
  // The same reason, whatever its figures, is said now and then; another one at once.
  if (said_.size() > kReasonsKept) said_.clear();
  ros::WallTime& said = said_[why.substr(0, why.find_first_of("0123456789"))];
  const auto now = ros::WallTime::now();
  if (now - said < kSayAgain) return;
  said = now;
  ROS_WARN("Scan dropped (%d of %d so far): %s", counts_.dropped, counts_.received, why.c_str());
}

void ScanSource::watch() {
  if (counts_.used == counts_at_watch_.used) {
    std::string why = "no scan came on " + subscriber_.getTopic();
    if (counts_.received > counts_at_watch_.received) {
      why = std::to_string(counts_.received - counts_at_watch_.received) + " scans came, but";
      std::string error;
      const bool placed = tf_.canTransform(odom_frame_, last_frame_, ros::Time(0), &error);
      why += placed ? " none could be used" : " tf does not place them: " + error;
    }
    ROS_WARN("Not localizing for %.0f s: %s", kWatchPeriod.toSec(), why.c_str());
  }
  counts_at_watch_ = counts_;
}

}  // namespace adaptive_localization
