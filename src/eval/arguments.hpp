// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options/option.hpp>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// The arguments that a program knows, each with what becomes of its value: --name VALUE or
/// --name=VALUE.
class ArgumentParser {
 public:
  /// Takes a value; throws std::invalid_argument if it is wrong.
  using Take = std::function<void(const std::string&)>;

  void flag(const std::string& name, bool& target);
  void text(const std::string& name, std::string& target);
  void number(const std::string& name, double& target);
  void option(const std::string& name, Take take);
  void list(const std::string& name, Take take);  // one value or more behind the name

  /// An argument of before; whoever gives it is told what does its work now.
  void gone(const std::string& name, const std::string& instead);

  /// What is no option; otherwise there may be no such thing.
  void others(Take take) { others_ = std::move(take); }

  /// False, without looking further, as soon as --help or -h is met. Throws std::invalid_argument
  /// naming the argument, the value and what was expected.
  bool parse(const std::vector<std::string>& arguments) const;

 private:
  enum class Values { kNone, kOne, kList };
  struct Entry {
    Take take;
    Values values;
  };

  std::vector<boost::program_options::option> read(const std::vector<std::string>& arguments) const;
  void take(const boost::program_options::option& given) const;
  [[noreturn]] void reject(const std::string& name) const;

  std::map<std::string, Entry> entries_;  // by name with its dashes
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
