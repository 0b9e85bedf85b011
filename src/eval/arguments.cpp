// SPDX-License-Identifier: BSD-3-Clause
#include "eval/arguments.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "core/suggestion.hpp"

namespace adaptive_localization {
namespace {

bool isOption(const std::string& argument) {
  return argument.compare(0, 2, "--") == 0;
}

int toWhole(const std::string& name, const std::string& text, const Range& range,
            const std::string& expected) {
  const double number = toNumber(name, text, range, expected);
  if (number == std::floor(number)) return static_cast<int>(number);
  throw std::invalid_argument(name + ": got '" + text + "', expected " + expected);
}

}  // namespace

void ArgumentParser::flag(const std::string& name, bool& target) {
  entries_[name] = {[&target](const std::string&) { target = true; }, false, false};
}

void ArgumentParser::text(const std::string& name, std::string& target) {
  option(name, [&target](const std::string& value) { target = value; });
}

void ArgumentParser::number(const std::string& name, double& target) {
  option(name, [name, &target](const std::string& value) { target = toNumber(name, value); });
}

void ArgumentParser::option(const std::string& name, Take take) {
  entries_[name] = {std::move(take), true, false};
}

void ArgumentParser::list(const std::string& name, Take take) {
  entries_[name] = {std::move(take), true, true};
}

bool ArgumentParser::parse(const std::vector<std::string>& arguments) const {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    const auto has_value = [&] { return i + 1 < arguments.size() && !isOption(arguments[i + 1]); };
    if (name == "--help" || name == "-h") return false;
    const auto entry = entries_.find(name);
    if (entry == entries_.end()) {
      if (isOption(name) || !others_) reject(name);
      others_(name);
    } else if (!entry->second.has_value) {
      entry->second.take("");
    } else {
      if (!has_value()) throw std::invalid_argument(name + " needs a value");
      do {
        entry->second.take(arguments[++i]);
      } while (entry->second.is_list && has_value());
    }
  }
  return true;
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
