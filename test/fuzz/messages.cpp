// SPDX-License-Identifier: BSD-3-Clause
// Messages with any numbers in them, as the node takes them, and those that it makes of them.
#include "../src/ros/conversions.hpp"
#include "fuzz/any_numbers.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

namespace {

void readScan(FuzzedDataProvider& given) {
  sensor_msgs::LaserScan message;
  message.header.stamp.fromSec(given.ConsumeFloatingPointInRange(0.0, 1e9));
  message.angle_min = static_cast<float>(al::anyNumber(given));
  message.angle_max = static_cast<float>(al::anyNumber(given));
  message.angle_increment = static_cast<float>(al::anyNumber(given));
  message.time_increment = static_cast<float>(al::anyNumber(given));
  message.range_min = static_cast<float>(al::anyNumber(given));
  message.range_max = static_cast<float>(al::anyNumber(given));
  message.ranges = al::anyNumbers<float>(given, 64);
  message.intensities = al::anyNumbers<float>(given, 64);
  al::ScanOptions options;
  options.laser_max_beams = given.ConsumeIntegralInRange(2, 100);
  const al::LaserScan scan = al::toLaserScan(message);
  al::toMessage(scan);
  al::toScan(scan, al::LaserMount{}, options);
}

void readMap(FuzzedDataProvider& given) {
  nav_msgs::OccupancyGrid message;
  message.info.width = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.info.height = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.info.resolution = static_cast<float>(al::anyNumber(given));
  message.info.origin.position.x = al::anyNumber(given);
  message.info.origin.position.y = al::anyNumber(given);
  message.info.origin.orientation.z = al::anyNumber(given);
  message.info.origin.orientation.w = al::anyNumber(given);
  message.data = al::anyNumbers<std::int8_t>(given, 64);
  al::toMessage(al::toGrid(message, given.ConsumeBool()));
}

void readPatch(FuzzedDataProvider& given) {
  map_msgs::OccupancyGridUpdate message;
  message.x = given.ConsumeIntegral<std::int32_t>();
  message.y = given.ConsumeIntegral<std::int32_t>();
  message.width = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.height = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.data = al::anyNumbers<std::int8_t>(given, 64);
  al::toPatch(message);
}

geometry_msgs::Quaternion readRotation(FuzzedDataProvider& given) {
  geometry_msgs::Quaternion message;
  message.x = al::anyNumber(given);
  message.y = al::anyNumber(given);
  message.z = al::anyNumber(given);
  message.w = al::anyNumber(given);
  return message;
}

void readPose(FuzzedDataProvider& given) {
  geometry_msgs::PoseWithCovariance message;
  message.pose.position.x = al::anyNumber(given);
  message.pose.position.y = al::anyNumber(given);
  message.pose.orientation = readRotation(given);
  for (double& entry : message.covariance) entry = al::anyNumber(given);
  const al::Gaussian2 pose = al::toGaussian(message);
  al::toMessage(pose.mean, pose.covariance);
  al::Particles particles(1);
  particles.setPose(0, pose.mean);
  al::toMessage(particles);
}

void readTransform(FuzzedDataProvider& given) {
  geometry_msgs::Transform message;
  message.translation.x = al::anyNumber(given);
  message.translation.y = al::anyNumber(given);
  message.translation.z = al::anyNumber(given);
  message.rotation = readRotation(given);
  const al::Pose2 pose = al::toPose2(message);
  al::checkPlace("base", "odom", pose.x, pose.y, 1e9);
  al::toTransformMessage(pose);
  al::toMount(message);
  al::toTransformMessage(al::toIsometry(message));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider given(data, size);
  void (*const readers[])(FuzzedDataProvider&) = {readScan, readMap, readPatch, readPose,
                                                  readTransform};
  const auto read = given.PickValueInArray(readers);
  return al::tryToRead([&] { read(given); });
}
