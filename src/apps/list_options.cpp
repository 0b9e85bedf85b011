// SPDX-License-Identifier: BSD-3-Clause
// Prints every option there is, as tables for doc/options.md or as a parameter file of one core.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../ros/node_options.hpp"
#include "../ros/reconfigure_fields.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "core/audience.hpp"
#include "eval/arguments.hpp"
#include "eval/program.hpp"
#include "match/scan_matcher.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {
namespace {

std::string usage() {
  return R"(usage: list_options                               tables in Markdown
       list_options --yaml CORE [--preset seed]   parameter file with the values of that core
       list_options --cfg                         fields of dynamic_reconfigure
)";
}

/// For people: whole numbers as they are, of others four digits.
std::string shortText(double number) {
  std::ostringstream text;
  const bool is_whole = number == std::floor(number) && std::abs(number) < 1e7;
  text << std::setprecision(is_whole ? 7 : 4) << number;
  return text.str();
}

std::string rangeText(const Range& range) {
  const bool is_limited = range.high < std::numeric_limits<double>::infinity() &&
                          range.high != kWhole.high;  // all that an int can hold
  if (is_limited) return shortText(range.low) + " to " + shortText(range.high);
  const bool is_bounded = range.low > -std::numeric_limits<double>::infinity();
  return is_bounded ? ">= " + shortText(range.low) : "";
}

/// The shortest text that reads back as the same number; other values as they are.
std::string exactText(const OptionValue& value) {
  const auto* number = std::get_if<double>(&value);
  for (int digits = 6; number && digits <= 17; ++digits) {
    std::ostringstream text;
    text << std::setprecision(digits) << *number;
    if (std::stod(text.str()) == *number) return text.str();
  }
  return toText(value);
}

std::string shortText(const OptionValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number ? shortText(*number) : toText(value);
}

/// What may stand there: one of some words, or a range with its unit.
std::string allowed(const OptionDescription& option) {
  std::string words;
  for (const auto& choice : option.choices) words += (words.empty() ? "" : ", ") + choice;
  if (!words.empty()) return words;
  const bool number = option.value.index() == 1 || option.value.index() == 2;
  const std::string range = number ? rangeText(option.range) : "";
  return range + (range.empty() || option.unit.empty() ? "" : " ") + option.unit;
}

using Values = std::map<std::string, OptionValue>;

/// What the default core runs with; of the others' options their own defaults.
Values defaultValues() {
  Values values;
  for (const auto& option : allOptions({})) values[option.key] = option.value;
  return values;
}

/// Those for an audience; nothing if there are none.
void printTable(const std::string& title, const std::vector<OptionDescription>& all,
                const Values& values, Audience audience) {
  std::vector<OptionDescription> options;
  std::copy_if(all.begin(), all.end(), std::back_inserter(options),
               [&](const auto& option) { return audienceOf(option.key) == audience; });
  if (options.empty()) return;
  std::cout << "**" << title
            << "**\n\n| option | default | allowed | meaning |\n|---|---|---|---|\n";
  for (const auto& option : options) {
    std::cout << "| `" << option.key << "` | " << shortText(values.at(option.key)) << " | "
              << allowed(option) << " | " << option.sentence << " |\n";
  }
  std::cout << '\n';
}

template <class Description>
void printModels(const Registry<Description>& known) {
  for (const auto& name : known.names()) {
    std::cout << "| `" << known.key() << "` | `" << name << "` | " << known.find(name).sentence
              << " |\n";
  }
}

void printTables() {
  const auto& filters = builtins().filters;
  std::cout << "| core | what it is |\n|---|---|\n";
  for (const auto& name : filters.names()) {
    const FilterDescription& filter = filters.find(name);
    std::cout << "| `" << name << "` | " << filter.sentence << " |\n";
  }
  std::cout << "\n| option | model | what it is |\n|---|---|---|\n";
  printModels(builtins().motions);
  printModels(builtins().observations);
  printModels(builtins().resamplings);
  std::cout << "\nDefaults are those of the default core, " << LocalizerOptions{}.filter
            << ", with its recommended preset.\n\n";
  const Values values = defaultValues();
  const std::vector<std::pair<std::string, std::vector<OptionDescription>>> tables{
      {"Localizer", describe(LocalizerOptions{})},
      {"Node only", describe(NodeOptions{})},
      {"Scans", describe(ScanOptions{})},
      {"Filters", optionsOfAll(builtins())},
      {"Matching scans", describe(MatchOptions{})},
      {"Confidence and status", describe(ConfidenceOptions{})},
      {"Compass", describe(CompassOptions{})},
      {"Energy grid", describe(EnergyGridOptions{})},
      {"Global search", describe(GlobalSearchOptions{})}};
  const std::vector<std::pair<Audience, std::string>> parts{
      {Audience::kUsers, "Options for users: what a robot and its place need"},
      {Audience::kAmcl, "amcl's options: the same names and meanings"},
      {Audience::kExperts, "Options for experts: how the algorithms work"}};
  for (const auto& [audience, heading] : parts) {
    std::cout << "## " << heading << "\n\n";
    for (const auto& [title, options] : tables) printTable(title, options, values, audience);
  }
}

void printYaml(const std::string& core, const std::string& preset) {
  Parameters parameters;
  parameters.set("filter", OptionValue{core});
  parameters.set("preset", OptionValue{preset});
  const Localizer localizer(parameters, trialMap());
  std::cout << "# Core " << core << ", preset " << preset << ": "
            << builtins().filters.find(core).sentence << '\n';
  for (const auto& option : localizer.effectiveOptions()) {
    if (exactText(option.value).empty()) continue;  // a folder of your own
    const std::string limits = allowed(option);
    std::cout << "\n# " << option.sentence << (limits.empty() ? "" : " [" + limits + "]") << '\n'
              << option.key << ": " << exactText(option.value) << '\n';
  }
}

std::string pythonText(const OptionValue& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "True" : "False";
  if (std::holds_alternative<std::string>(value)) return '"' + toText(value) + '"';
  return exactText(value);
}

std::string pythonLimit(const OptionDescription& option, const std::string& name, double limit) {
  if (!std::isfinite(limit)) return "";
  if (std::holds_alternative<double>(option.value)) return ", " + name + "=" + toText(limit);
  if (!std::holds_alternative<int>(option.value)) return "";
  return ", " + name + "=" + std::to_string(std::lround(limit));
}

/// The words of an option, as constants whose names are fit for C++.
std::string pythonEnum(const OptionDescription& option) {
  std::string constants;
  for (const auto& word : option.choices) {
    std::string name = option.key + "_" + word;
    std::replace(name.begin(), name.end(), '-', '_');
    constants += (constants.empty() ? "" : ", ") + ("gen.const(\"" + name) + "\", str_t, \"" +
                 word + "\", \"\")";
  }
  return "gen.enum([" + constants + "], \"\")";
}

void printCfg() {
  constexpr const char* kTypes[] = {"bool_t", "int_t", "double_t", "str_t"};
  std::cout
      << "#!/usr/bin/env python3\n"
         "# The fields that the node serves, for those who want a class of them. The node makes\n"
         "# them at run time, with those of plug-ins; scripts/update_docs writes this file.\n"
         "from dynamic_reconfigure.parameter_generator_catkin import *\n\n"
         "gen = ParameterGenerator()\n";
  for (const auto& field : fieldsOf(allOptions({}), {})) {
    std::cout << "gen.add(\"" << field.key << "\", " << kTypes[field.value.index()] << ", 0, \""
              << field.sentence << "\", " << pythonText(field.value);
    std::cout << pythonLimit(field, "min", field.range.low)
              << pythonLimit(field, "max", field.range.high);
    if (!field.choices.empty()) std::cout << ",\n        edit_method=" << pythonEnum(field);
    std::cout << ")\n";
  }
  std::cout << "\nexit(gen.generate(\"adaptive_localization\", \"adaptive_localization\", "
               "\"AdaptiveLocalization\"))\n";
}

struct ListCommand {
  bool is_cfg{false};
  std::string core;    // empty: all options
  std::string preset;  // empty: recommended
  bool wants_help{false};
};

ListCommand parse(const std::vector<std::string>& arguments) {
  ListCommand command;
  ArgumentParser parser;
  parser.flag("--cfg", command.is_cfg);
  parser.text("--yaml", command.core);
  parser.text("--preset", command.preset);
  command.wants_help = !parser.parse(arguments);
  if (command.is_cfg && !command.core.empty()) {
    throw std::invalid_argument("--cfg and --yaml exclude each other");
  }
  if (!command.preset.empty() && command.core.empty()) {
    throw std::invalid_argument("--preset needs --yaml CORE");
  }
  return command;
}

void list(const ListCommand& command) {
  if (command.is_cfg) return printCfg();
  if (command.core.empty()) return printTables();
  printYaml(command.core, command.preset.empty() ? "recommended" : command.preset);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("list_options", al::usage(), al::parse, al::list, {argv + 1, argv + argc});
}
