// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/filters/builtins.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "fuzz/input_file.hpp"
#include "match/scan_matcher.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return al::tryFile(data, size, "parameters.yaml", [](const auto& file) {
    al::Parameters parameters;
    parameters.load(file);
    parameters.read<al::LocalizerOptions>();
    parameters.read<al::ScanOptions>();
    parameters.read<al::MatchOptions>();
    parameters.unknownKeys();
  });
}
