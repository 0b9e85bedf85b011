// SPDX-License-Identifier: BSD-3-Clause
#include "../src/ros/pose_file.hpp"

#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return al::tryFile(data, size, "pose.yaml", [](const auto& file) {
    al::writePoseFile(file, al::readPoseFile(file).value());
    al::readAgain([&] { al::readPoseFile(file).value(); });
  });
}
