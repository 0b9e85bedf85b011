// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/core/options.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace adaptive_localization {
namespace {

[[noreturn]] void reject(const std::string& key, const OptionValue& value,
                         const std::string& expected) {
  throw std::invalid_argument("option '" + key + "': got '" + toText(value) + "', expected " +
                              expected);
}

/// What a number in a range is called.
std::string numberIn(const Range& range, const std::string& unit) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::ostringstream text;
  text.precision(10);
  if (range.high < kInfinity) {
    text << "number in [" << range.low << ", " << range.high << "]";
  } else {
    text << "finite number";
    if (range.low > -kInfinity) text << " >= " << range.low;
  }
  const bool is_bounded = range.low > -kInfinity || range.high < kInfinity;
  return text.str() + (unit.empty() ? "" : (is_bounded ? " " : ", ") + unit);
}

std::string join(const Choices& choices) {
  std::string text;
  for (const auto& choice : choices) text += (text.empty() ? "" : ", ") + choice;
  return text;
}

OptionValue parse(const YAML::Node& scalar) {
  if (scalar.Tag() == "!") return scalar.Scalar();  // quoted: text whatever it looks like
  bool truth{};
  if (YAML::convert<bool>::decode(scalar, truth)) return truth;
  int whole{};
  if (YAML::convert<int>::decode(scalar, whole)) return whole;
  double real{};
  if (YAML::convert<double>::decode(scalar, real)) return real;
  return scalar.Scalar();
}

}  // namespace

std::string toText(const OptionValue& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  std::ostringstream text;
  text.precision(15);
  std::visit([&](const auto& number) { text << number; }, value);
  return text.str();
}

void Parameters::set(const std::string& key, const std::string& text) {
  values_[key] = parse(YAML::Node(text));
}

void Parameters::load(const std::string& yaml_file) {
  try {
    const YAML::Node root = YAML::LoadFile(yaml_file);
    if (root.IsNull()) return;
    if (!root.IsMap()) throw std::invalid_argument("expected a map of key: value");
    for (const auto& entry : root) {
      const auto key = entry.first.as<std::string>();
      if (!entry.second.IsScalar()) throw std::invalid_argument("'" + key + "' is not one value");
      values_[key] = parse(entry.second);
    }
  } catch (const std::exception& error) {
    throw std::invalid_argument("parameter file '" + yaml_file + "': " + error.what());
  }
}

void Parameters::fill(const Parameters& defaults) {
  values_.insert(defaults.values_.begin(), defaults.values_.end());
}

std::vector<std::string> Parameters::unknownKeys() const {
  std::vector<std::string> unknown;
  for (const auto& entry : values_) {
    if (!read_.count(entry.first)) unknown.push_back(entry.first);
  }
  return unknown;
}

const OptionValue* Parameters::find(const std::string& key) const {
  read_.insert(key);
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

void Parameters::readOne(const std::string& key, bool& value, const std::string&) const {
  const OptionValue* given = find(key);
  if (!given) return;
  if (const auto* truth = std::get_if<bool>(given)) {
    value = *truth;
  } else if (const auto* number = std::get_if<int>(given); number && (*number | 1) == 1) {
    value = *number == 1;
  } else {
    reject(key, *given, "true or false");
  }
}

void Parameters::readOne(const std::string& key, int& value, const Range& range,
                         const std::string& unit, const std::string&) const {
  constexpr double kMost = std::numeric_limits<int>::max();
  const OptionValue* given = find(key);
  if (!given) return;
  double number = std::nan("");
  if (const auto* whole = std::get_if<int>(given)) number = *whole;
  if (const auto* real = std::get_if<double>(given)) number = *real;
  const Range ints{std::ceil(std::max(range.low, -kMost)), std::min(range.high, kMost)};
  if (!(number >= ints.low && number <= ints.high) || std::nearbyint(number) != number) {
    reject(key, *given, "a whole " + numberIn(ints, unit));
  }
  value = static_cast<int>(number);
}

void Parameters::readOne(const std::string& key, double& value, const Range& range,
                         const std::string& unit, const std::string&) const {
  const OptionValue* given = find(key);
  if (!given) return;
  double number = std::nan("");
  if (const auto* whole = std::get_if<int>(given)) number = *whole;
  if (const auto* real = std::get_if<double>(given)) number = *real;
  if (!std::isfinite(number) || number < range.low || number > range.high) {
    reject(key, *given, "a " + numberIn(range, unit));
  }
  value = number;
}

void Parameters::readOne(const std::string& key, std::string& value, const Choices& choices,
                         const std::string&) const {
  const OptionValue* given = find(key);
  if (!given) return;
  const std::string text = toText(*given);
  if (!choices.empty() && std::find(choices.begin(), choices.end(), text) == choices.end()) {
    reject(key, *given, "one of " + join(choices));
  }
  value = text;
}

}  // namespace adaptive_localization
