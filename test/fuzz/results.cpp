// SPDX-License-Identifier: BSD-3-Clause
// A file of results that is to be gone on with: it keeps the lines that it has.
#include "eval/experiment_file.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return al::tryFile(data, size, "results.jsonl", [](const auto& file) {
    const std::size_t runs = al::ExperimentFile(file).size();
    if (al::ExperimentFile(file).size() != runs) std::abort();
  });
}
