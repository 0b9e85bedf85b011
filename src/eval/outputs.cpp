// SPDX-License-Identifier: BSD-3-Clause
#include "eval/outputs.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace adaptive_localization {

void checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (const std::string& output : outputs) {
    for (const std::string& input : inputs) {
      std::error_code is_missing;  // then nothing is lost
      if (output.empty() || input.empty()) continue;
      if (!std::filesystem::equivalent(output, input, is_missing) || is_missing) continue;
      if (!std::filesystem::is_regular_file(input)) continue;  // /dev/null, say
      throw std::invalid_argument("output '" + output + "': is the input '" + input +
                                  "', expected another file");
    }
  }
}

}  // namespace adaptive_localization
