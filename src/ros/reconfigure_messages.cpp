// SPDX-License-Identifier: BSD-3-Clause
#include "reconfigure_messages.hpp"

#include <algorithm>
#include <limits>

#include "core/audience.hpp"

namespace adaptive_localization {
namespace {

using dynamic_reconfigure::Config;

/// As in amcl, and within it those for experts, folded up in rqt_reconfigure.
constexpr auto kGroup = "Default", kExperts = "Experts";

template <class Message, class Value>
void append(std::vector<Message>& messages, const std::string& name, const Value& value) {
  Message message;
  message.name = name;
  message.value = value;
  messages.push_back(message);
}

void add(Config& config, const std::string& key, bool value) {
  append(config.bools, key, value);
}
void add(Config& config, const std::string& key, int value) {
  append(config.ints, key, value);
}
void add(Config& config, const std::string& key, double value) {
  append(config.doubles, key, value);
}
void add(Config& config, const std::string& key, const std::string& value) {
  append(config.strs, key, value);
}

Config emptyConfig() {
  Config config;
  config.groups.resize(2);
  config.groups[0].name = kGroup;
  config.groups[0].state = true;
  config.groups[1].name = kExperts;
  config.groups[1].state = false;
  config.groups[1].id = 1;
  return config;
}

/// One end of an option's range, of the option's type.
OptionValue limitOf(const OptionDescription& option, double limit, bool is_high) {
  if (std::holds_alternative<bool>(option.value)) return is_high;
  if (std::holds_alternative<double>(option.value)) return limit;
  if (std::holds_alternative<std::string>(option.value)) return std::string();
  using Int = std::numeric_limits<int>;
  return static_cast<int>(std::clamp<double>(limit, Int::min(), Int::max()));
}

const char* typeOf(const OptionValue& value) {
  constexpr const char* kTypes[] = {"bool", "int", "double", "str"};
  return kTypes[value.index()];
}

/// Choices as dynamic_reconfigure's clients read them: a dictionary in Python.
std::string editMethod(const OptionDescription& option) {
  if (option.choices.empty()) return "";
  std::string words;
  for (const auto& choice : option.choices) {
    words += (words.empty() ? "" : ", ") + std::string("{'name': '") + choice + "', 'value': '" +
             choice + "', 'type': 'str', 'description': ''}";
  }
  return "{'enum': [" + words + "], 'enum_description': ''}";
}

}  // namespace

Values valuesOf(const Config& message) {
  Values values;
  for (const auto& field : message.bools) values[field.name] = field.value != 0;
  for (const auto& field : message.ints) values[field.name] = field.value;
  for (const auto& field : message.doubles) values[field.name] = field.value;
  for (const auto& field : message.strs) values[field.name] = field.value;
  return values;
}

Config toConfig(const std::vector<OptionDescription>& options) {
  Config config = emptyConfig();
  for (const auto& option : options) {
    std::visit([&](const auto& value) { add(config, option.key, value); }, option.value);
  }
  return config;
}

dynamic_reconfigure::ConfigDescription toDescription(
    const std::vector<OptionDescription>& options) {
  dynamic_reconfigure::ConfigDescription description;
  description.groups.resize(2);
  description.groups[0].name = kGroup;
  description.groups[1].name = kExperts;
  description.groups[1].type = "collapse";
  description.groups[1].id = 1;
  std::vector<OptionDescription> low = options;
  std::vector<OptionDescription> high = options;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const OptionDescription& option = options[i];
    low[i].value = limitOf(option, option.range.low, false);
    high[i].value = limitOf(option, option.range.high, true);
    dynamic_reconfigure::ParamDescription field;
    field.name = option.key;
    field.type = typeOf(option.value);
    field.description = option.sentence + (option.unit.empty() ? "" : " [" + option.unit + "]");
    field.edit_method = editMethod(option);
    const bool is_expert = audienceOf(option.key) == Audience::kExperts;
    description.groups[is_expert ? 1 : 0].parameters.push_back(field);
  }
  description.min = toConfig(low);
  description.max = toConfig(high);
  description.dflt = toConfig(options);
  return description;
}

}  // namespace adaptive_localization
