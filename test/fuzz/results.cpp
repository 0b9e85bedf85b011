// SPDX-License-Identifier: BSD-3-Clause
// A file of results that is to be gone on with: it keeps the lines that it has, and takes another.
#include "eval/experiment_file.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return al::tryFile(data, size, "results.jsonl", [](const auto& file) {
    std::size_t runs = 0;
    {
      al::ExperimentFile results(file);
      al::ExperimentResult result;
      result.trials.emplace_back();
      results.add(result);
      runs = results.size();
    }
    al::readAgain([&] {
      if (al::ExperimentFile(file).size() != runs) std::abort();
    });
  });
}
