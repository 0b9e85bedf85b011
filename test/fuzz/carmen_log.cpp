// SPDX-License-Identifier: BSD-3-Clause
// A CARMEN log, packed or not, as its first byte says.
#include "eval/carmen_log.hpp"

#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string names[] = {"drive.log", "drive.log.gz", "drive.log.bz2"};
  if (size == 0) return 0;
  const std::string& name = names[data[0] == 0x1f ? 1 : data[0] == 'B' ? 2 : 0];
  return al::tryFile(data, size, name, [](const auto& file) {
    al::LogRequest request;
    request.file = file;
    al::readCarmenLog(request);
  });
}
