// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// The arguments that a program knows, each with what becomes of its value.
class ArgumentParser {
 public:
  /// Takes a value; throws std::invalid_argument if it is wrong.
  using Take = std::function<void(const std::string&)>;

  void flag(const std::string& name, bool& target);
  void text(const std::string& name, std::string& target);
  void number(const std::string& name, double& target);
  void option(const std::string& name, Take take);
  void list(const std::string& name, Take take);  // one value or more behind the name

  /// What is no option; otherwise there may be no such thing.
  void others(Take take) { others_ = std::move(take); }

  /// False, without looking further, as soon as --help or -h is met. Throws std::invalid_argument
  /// naming the argument, the value and what was expected.
  bool parse(const std::vector<std::string>& arguments) const;

 private:
  struct Entry {
    Take take;
    bool has_value{true};
    bool is_list{false};
  };

  [[noreturn]] void reject(const std::string& name) const;

  std::map<std::string, Entry> entries_;
  Take others_;
};

/// The number that a text says. Throws std::invalid_argument naming the argument, the text and what
/// was expected.
double toNumber(const std::string& name, const std::string& text, const Range& range = {},
                const std::string& expected = "a number");

/// The same of a whole number from 1 to `most`, which is what was expected, if nothing else is
/// said.
int toCount(const std::string& name, const std::string& text, int most,
            const std::string& expected = "");

/// The same of a seed, a whole number from 0.
int toSeed(const std::string& name, const std::string& text);

/// The same of KEY=VALUE.
std::pair<std::string, std::string> toKeyAndValue(const std::string& name, const std::string& text);

}  // namespace adaptive_localization
