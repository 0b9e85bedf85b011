// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// The range an option's value must lie in, both ends included but for infinite ones.
struct Range {
  double low{-std::numeric_limits<double>::infinity()};
  double high{std::numeric_limits<double>::infinity()};
};

// The ends are generous and yet there: what is beyond is a slip, and squares of it are no numbers.
constexpr Range kPositive{1e-6, 1e6};
constexpr Range kNotNegative{0.0, 1e6};
constexpr Range kProbability{0.0, 1.0};
constexpr Range kDeviation{0.0, 1e3};  // standard deviations and noises, m or rad
constexpr Range kPositiveDeviation{1e-6, 1e3};
constexpr Range kVariance{0.0, 1e12};  // of a place that may be anywhere, m^2 or rad^2
constexpr Range kCoordinate{-kFarthest, kFarthest};  // m; rad
constexpr Range kWhole{0.0, std::numeric_limits<int>::max()};

using Choices = std::vector<std::string>;  // empty: any text

using OptionValue = std::variant<bool, int, double, std::string>;

std::string toText(const OptionValue& value);

/// One option as a user sees it.
struct OptionDescription {
  std::string key;
  OptionValue value;  // the default
  Range range;
  Choices choices;
  std::string unit;
  std::string sentence;
};

/// Values given by name, from a YAML file, the command line or a parameter server. Remembers which
/// were read, so that a misspelt key is not lost in silence.
///
/// A component keeps its options in one struct whose member initialisers are the defaults:
///
///     struct GateOptions {
///       double update_min_d{0.2};
///       template <class Visitor>
///       void visit(Visitor&& option) {
///         option("update_min_d", update_min_d, kNotNegative, "m", "Distance that ...");
///       }
///     };
///     const auto options = parameters.read<GateOptions>();
///
/// This list is the only place where a key, its default, range, unit and meaning stand.
class Parameters {
 public:
  /// Text is taken as YAML takes it: true, 3, 0.5 and anything else.
  void set(const std::string& key, const std::string& text);
  void set(const std::string& key, OptionValue value) { values_[key] = std::move(value); }
  bool has(const std::string& key) const { return values_.count(key) > 0; }

  /// Adds the flat key: value pairs of a YAML file; a later file wins.
  /// Throws std::invalid_argument naming the file when it is missing or no flat map.
  void load(const std::string& yaml_file);

  /// Adds values where this has none yet.
  void fill(const Parameters& defaults);

  /// Options with their defaults overridden by what was given.
  /// Throws std::invalid_argument naming key, value and range.
  template <class Options>
  Options read() const {
    return read(Options{});
  }
  template <class Options>
  Options read(Options options) const {
    options.visit([this](const std::string& key, auto& value, const auto&... about) {
      this->readOne(key, value, about...);
    });
    return options;
  }

  /// Keys that nobody has read.
  std::vector<std::string> unknownKeys() const;

  /// Counts a key as read though no options struct has it.
  void acknowledge(const std::string& key) const { read_.insert(key); }

  const std::map<std::string, OptionValue>& values() const { return values_; }

 private:
  void readOne(const std::string& key, bool& value, const std::string& sentence) const;
  void readOne(const std::string& key, int& value, const Range& range, const std::string& unit,
               const std::string& sentence) const;
  void readOne(const std::string& key, double& value, const Range& range, const std::string& unit,
               const std::string& sentence) const;
  void readOne(const std::string& key, std::string& value, const Choices& choices,
               const std::string& sentence) const;
  const OptionValue* find(const std::string& key) const;

  std::map<std::string, OptionValue> values_;
  mutable std::set<std::string> read_;
};

/// Collects what a struct's visit() says: used for tables, YAML files and the effective options.
class OptionList {
 public:
  void operator()(const std::string& key, bool value, const std::string& sentence) {
    rows_.push_back({key, value, {}, {}, "", sentence});
  }
  void operator()(const std::string& key, int value, const Range& range, const std::string& unit,
                  const std::string& sentence) {
    rows_.push_back({key, value, range, {}, unit, sentence});
  }
  void operator()(const std::string& key, double value, const Range& range, const std::string& unit,
                  const std::string& sentence) {
    rows_.push_back({key, value, range, {}, unit, sentence});
  }
  void operator()(const std::string& key, const std::string& value, const Choices& choices,
                  const std::string& sentence) {
    rows_.push_back({key, value, {}, choices, "", sentence});
  }
  const std::vector<OptionDescription>& rows() const { return rows_; }

 private:
  std::vector<OptionDescription> rows_;
};

template <class Options>
std::vector<OptionDescription> describe(Options options) {
  OptionList list;
  options.visit(list);
  return list.rows();
}

}  // namespace adaptive_localization
