// SPDX-License-Identifier: BSD-3-Clause
// Pictures and what is told of their camera, with any numbers in them.
#include "../src/ros/image_messages.hpp"
#include "fuzz/any_numbers.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

namespace {

void readPicture(FuzzedDataProvider& given) {
  constexpr const char* kEncodings[] = {"mono8", "rgb8", "bgr8", "32FC1"};
  sensor_msgs::Image message;
  message.encoding = given.PickValueInArray(kEncodings);
  message.width = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.height = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.step = given.ConsumeIntegral<std::uint32_t>();
  message.data = al::anyNumbers<std::uint8_t>(given, 300);
  al::toGrey(message);
}

void readCamera(FuzzedDataProvider& given) {
  constexpr const char* kModels[] = {"plumb_bob", "rational_polynomial", "equidistant", ""};
  sensor_msgs::CameraInfo message;
  message.width = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.height = given.ConsumeIntegralInRange<std::uint32_t>(0, 9);
  message.distortion_model = given.PickValueInArray(kModels);
  for (double& entry : message.K) entry = al::anyNumber(given);
  for (double& entry : message.P) entry = al::anyNumber(given);
  message.D = al::anyNumbers<double>(given, 14);
  al::toCalibration(message, given.ConsumeBool());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider given(data, size);
  return al::tryToRead([&] { given.ConsumeBool() ? readPicture(given) : readCamera(given); });
}
