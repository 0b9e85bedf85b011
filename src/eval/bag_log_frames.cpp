// SPDX-License-Identifier: BSD-3-Clause
#include "bag_log_frames.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <utility>

namespace adaptive_localization {
namespace {

constexpr double kPatience = 5.0;  // s; how much later a transform may be recorded than its scan
const char kAuthority[] = "bag";

LaserScan toPlainScan(const sensor_msgs::LaserScan& message) {
  LaserScan scan;
  scan.stamp = message.header.stamp.toSec();
  scan.angle_min = message.angle_min;
  scan.angle_increment = message.angle_increment;
  scan.time_increment = message.time_increment;
  scan.range_min = message.range_min;
  scan.range_max = message.range_max;
  scan.ranges = message.ranges;
  return scan;
}

Eigen::Matrix3d rotation(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
}

}  // namespace

void BagFrames::add(const tf2_msgs::TFMessage& message, bool is_static) {
  for (auto transform : message.transforms) {
    transform.header.frame_id = withoutLeadingSlash(transform.header.frame_id);
    transform.child_frame_id = withoutLeadingSlash(transform.child_frame_id);
    try {
      if (!buffer_.setTransform(transform, kAuthority, is_static)) ++refused_;
    } catch (const std::runtime_error&) {  // a stamp too large for ros::Time's arithmetic
      ++refused_;
      continue;
    }
    if (!is_static) newest_ = std::max(newest_, transform.header.stamp.toSec());
  }
  placeWaiting(false);
}

void BagFrames::add(const sensor_msgs::LaserScan& scan) {
  waiting_.push_back(scan);
  placeWaiting(false);
}

std::vector<BagFrames::PlacedScan> BagFrames::finish() {
  placeWaiting(true);
  for (auto& placed : placed_) {
    if (!placed.has_mount) mount(placed, ros::Time(0));
  }
  return std::move(placed_);
}

Eigen::Isometry3d BagFrames::placeOf(const std::string& frame) const {
  const std::string base = withoutLeadingSlash(frames_.base_frame_id);
  const auto transform = buffer_.lookupTransform(base, frame, ros::Time(0)).transform;
  const auto& t = transform.translation;
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.linear() = rotation(transform.rotation);
  place.translation() = Eigen::Vector3d(t.x, t.y, t.z);
  return place;
}

void BagFrames::placeWaiting(bool is_last_chance) {
  while (!waiting_.empty()) {
    const auto& message = waiting_.front();
    const ros::Time stamp = message.header.stamp;
    const auto T_odom_base = odometryAt(stamp);
    if (!T_odom_base && !is_last_chance && newest_ - stamp.toSec() < kPatience) return;

    PlacedScan placed;
    placed.scan.scan = toPlainScan(message);
    placed.frame = withoutLeadingSlash(message.header.frame_id);
    placed.has_odometry = T_odom_base.has_value();
    placed.scan.T_odom_base = T_odom_base.value_or(Pose2{});
    if (keeps_intensities_) placed.scan.scan.intensities = message.intensities;
    mount(placed, stamp);
    placed_.push_back(std::move(placed));
    waiting_.pop_front();
  }
}

std::optional<geometry_msgs::Transform> BagFrames::lookUp(const std::string& target,
                                                          const std::string& source,
                                                          const ros::Time& stamp) const {
  try {
    if (!buffer_.canTransform(target, source, stamp)) return {};
    return buffer_.lookupTransform(target, source, stamp).transform;
  } catch (const std::runtime_error&) {  // stamps too far apart for ros::Duration
    return {};
  }
}

std::optional<Pose2> BagFrames::odometryAt(const ros::Time& stamp) const {
  const auto transform = lookUp(withoutLeadingSlash(frames_.odom_frame_id),
                                withoutLeadingSlash(frames_.base_frame_id), stamp);
  if (!transform) return {};
  const Eigen::Matrix3d axes = rotation(transform->rotation);
  const Pose2 pose{transform->translation.x, transform->translation.y,
                   std::atan2(axes(1, 0), axes(0, 0))};
  return isFinite(pose) ? std::optional<Pose2>(pose) : std::nullopt;
}

void BagFrames::mount(PlacedScan& placed, const ros::Time& stamp) const {
  const std::string base = withoutLeadingSlash(frames_.base_frame_id);
  placed.has_mount = placed.frame == base;
  if (placed.has_mount) return;
  for (const ros::Time& instant : {stamp, ros::Time(0)}) {  // 0: the latest there is
    const auto transform = lookUp(base, placed.frame, instant);
    if (!transform) continue;
    LaserMount mount;
    mount.position = {transform->translation.x, transform->translation.y};
    mount.axes = rotation(transform->rotation).topLeftCorner<2, 2>();
    if (!mount.position.allFinite() || !mount.axes.allFinite()) continue;
    placed.scan.mount = mount;
    placed.has_mount = true;
    return;
  }
}

}  // namespace adaptive_localization
