// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>

#include "eval/replay_command.hpp"
#include "fuzz/input_file.hpp"

namespace al = adaptive_localization;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream input(std::string(reinterpret_cast<const char*>(data), size));
  std::vector<std::string> words;
  for (std::string word; std::getline(input, word);) words.push_back(word);
  return al::tryToRead([&] { al::parseReplayCommand(words); });
}
