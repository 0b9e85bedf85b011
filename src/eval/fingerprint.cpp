// SPDX-License-Identifier: BSD-3-Clause
#include "fingerprint.hpp"

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace adaptive_localization {
namespace {

std::string contentsOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::string hashOf(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char letter : text) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::string fingerprint(const YamlValue& value, const ExperimentCase& of_case) {
  YAML::Node node = YAML::Clone(value.node());
  for (const char* key : {"label", "cores", "options", "seeds", "world", "map"}) node.remove(key);
  return hashOf(YAML::Dump(node) + contentsOf(of_case.world) + contentsOf(of_case.map));
}

}  // namespace adaptive_localization
