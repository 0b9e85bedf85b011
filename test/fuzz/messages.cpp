// SPDX-License-Identifier: BSD-3-Clause
// Messages with any numbers in them, as the node takes them.
#include <fuzzer/FuzzedDataProvider.h>

#include "../src/ros/conversions.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

namespace {

template <class Number>
std::vector<Number> numbers(FuzzedDataProvider& given) {
  std::vector<Number> all(given.ConsumeIntegralInRange<std::size_t>(0, 64));
  if (!all.empty()) given.ConsumeData(all.data(), all.size() * sizeof(Number));
  return all;
}

double number(FuzzedDataProvider& given) {
  return given.ConsumeBool() ? given.ConsumeFloatingPoint<double>()
                             : given.ConsumeFloatingPointInRange(-10.0, 10.0);
}

void readScan(FuzzedDataProvider& given) {
  sensor_msgs::LaserScan message;
  message.header.stamp.fromSec(given.ConsumeFloatingPointInRange(0.0, 1e9));
  message.angle_min = static_cast<float>(number(given));
  message.angle_max = static_cast<float>(number(given));
  message.angle_increment = static_cast<float>(number(given));
  message.time_increment = static_cast<float>(number(given));
  message.range_min = static_cast<float>(number(given));
  message.range_max = static_cast<float>(number(given));
  message.ranges = numbers<float>(given);
  message.intensities = numbers<float>(given);
  al::ScanOptions options;
  options.laser_max_beams = given.ConsumeIntegralInRange(2, 100);
  al::toScan(al::toLaserScan(message), al::LaserMount{}, options);
}

void readMap(FuzzedDataProvider& given) {
  nav_msgs::OccupancyGrid message;
  message.info.width = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.info.height = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.info.resolution = static_cast<float>(number(given));
  message.info.origin.position.x = number(given);
  message.info.origin.position.y = number(given);
  message.info.origin.orientation.z = number(given);
  message.info.origin.orientation.w = number(given);
  message.data = numbers<std::int8_t>(given);
  al::toGrid(message, given.ConsumeBool());
}

void readPatch(FuzzedDataProvider& given) {
  map_msgs::OccupancyGridUpdate message;
  message.x = given.ConsumeIntegral<std::int32_t>();
  message.y = given.ConsumeIntegral<std::int32_t>();
  message.width = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.height = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.data = numbers<std::int8_t>(given);
  al::toPatch(message);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider given(data, size);
  void (*const readers[])(FuzzedDataProvider&) = {readScan, readMap, readPatch};
  const auto read = readers[given.ConsumeIntegralInRange<std::size_t>(0, 2)];
  return al::tryToRead([&] { read(given); });
}
