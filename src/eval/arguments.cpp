// SPDX-License-Identifier: BSD-3-Clause
#include "eval/arguments.hpp"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <boost/program_options/value_semantic.hpp>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "core/suggestion.hpp"

namespace po = boost::program_options;

namespace adaptive_localization {
namespace {

int toWhole(const std::string& name, const std::string& text, const Range& range,
            const std::string& expected) {
  const double number = toNumber(name, text, range, expected);
  if (number == std::floor(number)) return static_cast<int>(number);
  throw std::invalid_argument(name + ": got '" + text + "', expected " + expected);
}

}  // namespace

void ArgumentParser::flag(const std::string& name, bool& target) {
  entries_[name] = {[&target](const std::string&) { target = true; }, Values::kNone};
}

void ArgumentParser::text(const std::string& name, std::string& target) {
  option(name, [&target](const std::string& value) { target = value; });
}

void ArgumentParser::number(const std::string& name, double& target) {
  option(name, [name, &target](const std::string& value) { target = toNumber(name, value); });
}

void ArgumentParser::option(const std::string& name, Take take) {
  entries_[name] = {std::move(take), Values::kOne};
}

void ArgumentParser::list(const std::string& name, Take take) {
  entries_[name] = {std::move(take), Values::kList};
}

void ArgumentParser::gone(const std::string& name, const std::string& instead) {
  option(name, [name, instead](const std::string&) {
    throw std::invalid_argument(name + " is no more, expected " + instead);
  });
}

bool ArgumentParser::parse(const std::vector<std::string>& arguments) const {
  for (const auto& argument : arguments) {
    if (argument == "--help" || argument == "-h") return false;
  }
  try {
    for (const auto& given : read(arguments)) take(given);
  } catch (const po::unknown_option& error) {
    reject(error.get_option_name());
  } catch (const po::invalid_command_line_syntax& error) {
    const bool is_missing = error.kind() == error.missing_parameter;
    throw std::invalid_argument(error.get_option_name() +
                                (is_missing ? " needs a value" : " takes no value"));
  }
  return true;
}

std::vector<po::option> ArgumentParser::read(const std::vector<std::string>& arguments) const {
  po::options_description known;
  for (const auto& [name, entry] : entries_) {
    auto* values = po::value<std::vector<std::string>>();
    if (entry.values == Values::kList) values->multitoken();
    if (entry.values == Values::kNone) values->zero_tokens();
    known.add_options()(name.substr(2).c_str(), values);
  }
  constexpr int kStyle = po::command_line_style::allow_long |  // -1,0,0 is a value
                         po::command_line_style::long_allow_adjacent |
                         po::command_line_style::long_allow_next;
  return po::command_line_parser(arguments).options(known).style(kStyle).run().options;
}

void ArgumentParser::take(const po::option& given) const {
  const bool is_other = given.string_key.empty();
  if (is_other && !others_) reject(given.value.front());
  const Take& taker = is_other ? others_ : entries_.at("--" + given.string_key).take;
  if (given.value.empty()) taker("");
  for (const auto& value : given.value) {
    if (value.compare(0, 2, "--") == 0) {  // Boost takes the next argument, whatever it is
      throw std::invalid_argument(given.original_tokens.front() + " needs a value");
    }
    taker(value);
  }
}

void ArgumentParser::reject(const std::string& name) const {
  auto known = entries_;
  known["--help"] = {};
  throw std::invalid_argument("unknown argument '" + name + "'" + suggestion(name, known));
}

double toNumber(const std::string& name, const std::string& text, const Range& range,
                const std::string& expected) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool is_number = !text.empty() && *end == '\0' && std::isfinite(number);
  if (is_number && number >= range.low && number <= range.high) return number;
  throw std::invalid_argument(name + ": got '" + text + "', expected " + expected);
}

int toCount(const std::string& name, const std::string& text, int most,
            const std::string& expected) {
  const std::string what =
      expected.empty() ? "a whole number from 1 to " + std::to_string(most) : expected;
  return toWhole(name, text, {1.0, static_cast<double>(most)}, what);
}

int toSeed(const std::string& name, const std::string& text) {
  return toWhole(name, text, kWhole, "a whole number from 0");
}

std::pair<std::string, std::string> toKeyAndValue(const std::string& name,
                                                  const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw std::invalid_argument(name + ": got '" + text + "', expected KEY=VALUE");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace adaptive_localization
