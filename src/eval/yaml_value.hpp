// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// A value of a YAML file that knows its place in it, so that what is wrong can be said in a way
/// that helps: every member throws std::invalid_argument naming file, key, value and expectation.
class YamlValue {
 public:
  /// The whole of a file.
  YamlValue(const YAML::Node& root, std::string file) : node_(root), file_(std::move(file)) {}

  bool has(const std::string& key) const { return node_.IsMap() && node_[key]; }
  YamlValue at(const std::string& key) const;  // rejects when there is none
  std::vector<YamlValue> list(const std::string& expected) const;

  std::string text() const;
  std::string oneOf(const Choices& choices) const;
  bool truth() const;
  double number(const Range& range) const;
  int whole(const Range& range) const;
  std::vector<double> numbers(std::size_t count, const std::string& expected) const;
  Parameters parameters() const;  // of a flat map

  /// Rejects anything but a map with some of these keys.
  void allowOnly(const std::set<std::string>& keys) const;

  [[noreturn]] void reject(const std::string& expected) const;

  const YAML::Node& node() const { return node_; }
  const std::string& file() const { return file_; }
  const std::string& key() const { return key_; }

 private:
  YamlValue(const YAML::Node& node, std::string file, std::string key)
      : node_(node), file_(std::move(file)), key_(std::move(key)) {}

  YAML::Node node_;
  std::string file_;
  std::string key_;  // events[1].share
};

/// What `over` says, and what `base` says where it does not; maps are merged key by key.
YAML::Node merged(const YAML::Node& base, const YAML::Node& over);

}  // namespace adaptive_localization
