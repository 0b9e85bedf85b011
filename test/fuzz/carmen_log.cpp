// SPDX-License-Identifier: BSD-3-Clause
#include "eval/carmen_log.hpp"

#include <sstream>

#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream input(std::string(reinterpret_cast<const char*>(data), size));
  return al::tryToRead([&] { al::readCarmenLog(input, al::LogRequest{}); });
}
