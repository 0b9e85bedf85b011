// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_value.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace adaptive_localization {
namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string toText(const Range& range) {
  std::ostringstream text;
  text << "in [" << range.low << ", " << range.high << "]";
  return text.str();
}

std::string shown(const YAML::Node& node) {
  if (!node || node.IsNull()) return "nothing";
  if (node.IsScalar()) return "'" + node.Scalar() + "'";
  YAML::Emitter emitter;
  emitter.SetSeqFormat(YAML::Flow);
  emitter.SetMapFormat(YAML::Flow);
  emitter << node;
  return std::string("'") + emitter.c_str() + "'";
}

}  // namespace

void YamlValue::reject(const std::string& expected) const {
  throw std::invalid_argument("file '" + file_ + "': " + (key_.empty() ? "" : "'" + key_ + "': ") +
                              "got " + shown(node_) + ", expected " + expected);
}

YamlValue YamlValue::at(const std::string& key) const {
  const std::string path = key_.empty() ? key : key_ + "." + key;
  if (!node_.IsMap() || !node_[key]) {
    throw std::invalid_argument("file '" + file_ + "': '" + path + "' is missing");
  }
  return {node_[key], file_, path};
}

std::vector<YamlValue> YamlValue::list(const std::string& expected) const {
  if (!node_.IsSequence() || node_.size() == 0) reject(expected);
  std::vector<YamlValue> values;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    values.push_back({node_[i], file_, key_ + "[" + std::to_string(i) + "]"});
  }
  return values;
}

std::string YamlValue::text() const {
  if (!node_.IsScalar() || node_.Scalar().empty()) reject("a text");
  return node_.Scalar();
}

std::string YamlValue::oneOf(const Choices& choices) const {
  for (const auto& choice : choices) {
    if (node_.IsScalar() && node_.Scalar() == choice) return choice;
  }
  reject("one of " + join(choices));
}

bool YamlValue::truth() const {
  bool value{};
  if (!node_.IsScalar() || !YAML::convert<bool>::decode(node_, value)) reject("true or false");
  return value;
}

double YamlValue::number(const Range& range) const {
  double value{};
  const bool is_number = node_.IsScalar() && YAML::convert<double>::decode(node_, value);
  if (!is_number || !(value >= range.low && value <= range.high) || !std::isfinite(value)) {
    reject("a number " + toText(range));
  }
  return value;
}

int YamlValue::whole(const Range& range) const {
  int value{};
  const bool is_whole = node_.IsScalar() && YAML::convert<int>::decode(node_, value);
  if (!is_whole || value < range.low || value > range.high) {
    reject("a whole number " + toText(range));
  }
  return value;
}

std::vector<double> YamlValue::numbers(std::size_t count, const std::string& expected) const {
  std::vector<double> values;
  bool good = node_.IsSequence() && (count == 0 || node_.size() == count);
  for (std::size_t i = 0; good && i < node_.size(); ++i) {
    double value{};
    good = node_[i].IsScalar() && YAML::convert<double>::decode(node_[i], value) &&
           std::isfinite(value);
    values.push_back(value);
  }
  if (!good) reject(expected);
  return values;
}

Parameters YamlValue::parameters() const {
  if (!node_.IsMap()) reject("a map of key: value");
  Parameters values;
  for (const auto& entry : node_) {
    const std::string key = entry.first.Scalar();
    const std::string value = at(key).text();
    if (entry.second.Tag() == "!") {  // quoted: text whatever it looks like
      values.set(key, OptionValue(value));
    } else {
      values.set(key, value);
    }
  }
  return values;
}

void YamlValue::allowOnly(const std::set<std::string>& keys) const {
  const std::string expected =
      "a map with keys among " + join(std::vector<std::string>(keys.begin(), keys.end()));
  if (!node_.IsMap()) reject(expected);
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) reject(expected);
    if (keys.count(entry.first.Scalar())) continue;
    throw std::invalid_argument("file '" + file_ + "': unknown key '" +
                                (key_.empty() ? "" : key_ + ".") + entry.first.Scalar() +
                                "', expected " + expected);
  }
}

YAML::Node merged(const YAML::Node& base, const YAML::Node& over) {
  if (!base.IsMap() || !over.IsMap()) return YAML::Clone(over);
  YAML::Node result = YAML::Clone(base);
  for (const auto& entry : over) {
    const std::string key = entry.first.Scalar();
    const bool is_there = base[key].IsDefined();
    result[key] = is_there ? merged(base[key], entry.second) : YAML::Clone(entry.second);
  }
  return result;
}

}  // namespace adaptive_localization
