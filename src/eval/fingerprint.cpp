// SPDX-License-Identifier: BSD-3-Clause
#include "fingerprint.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "experiment_values.hpp"

namespace adaptive_localization {
namespace {

/// Of what is no file, nothing: it is refused when it is loaded.
std::string contentsOf(const std::string& file) {
  std::error_code is_none;
  if (!std::filesystem::is_regular_file(file, is_none)) return {};
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The YAML file and its image, if it names one.
std::string contentsOfMap(const std::string& file) {
  const std::string text = contentsOf(file);
  try {
    const std::filesystem::path image = YAML::Load(text)["image"].as<std::string>("");
    return text + contentsOf((std::filesystem::path(file).parent_path() / image).string());
  } catch (const YAML::Exception&) {
    return text;
  }
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
  return hashOf(YAML::Dump(node) + contentsOf(of_case.world) + contentsOfMap(of_case.map));
}

std::string fingerprint(const Parameters& parameters) {
  std::string settings;
  for (const auto& [key, value] : parameters.values()) {
    const bool is_file =
        std::find(kMapOptions.begin(), kMapOptions.end(), key) != kMapOptions.end();
    const std::string text = toText(value);
    settings += "\n" + key + ": " + (is_file ? contentsOf(text) : text);
  }
  return hashOf(settings);
}

}  // namespace adaptive_localization
