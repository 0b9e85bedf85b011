// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/replay_command.hpp"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>

#include "adaptive_localization/core/suggestion.hpp"

namespace adaptive_localization {
namespace {

double toNumber(const std::string& name, const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(number)) {
    throw std::invalid_argument(name + ": got '" + text + "', expected a number");
  }
  return number;
}

int toCount(const std::string& name, const std::string& text) {
  const double number = toNumber(name, text);
  if (number < 1.0 || number > 1e9 || number != std::floor(number)) {
    throw std::invalid_argument(name + ": got '" + text + "', expected a whole number from 1");
  }
  return static_cast<int>(number);
}

/// What to do with the value of each option.
using Handlers = std::map<std::string, std::function<void(const std::string&)>>;

bool isOption(const std::string& argument) {
  return argument.compare(0, 2, "--") == 0;
}

void checkRequired(const ReplayCommand& command) {
  if (command.map.empty()) throw std::invalid_argument("--map is missing");
  if (command.log.file.empty()) throw std::invalid_argument("--log is missing");
  if (command.log.begin > command.log.end) {
    throw std::invalid_argument("--begin is later than --end");
  }
  if (!command.truth_file.empty() && !command.log.truth_topic.empty()) {
    throw std::invalid_argument("--truth and --truth-topic exclude each other");
  }
}

/// What --params, --set, --filter, --seed and --threads say, to be layered at the end.
struct GivenParameters {
  std::vector<std::string> files;
  std::vector<std::pair<std::string, std::string>> values;
  Parameters own;

  Parameters layer() const {
    Parameters all = own;
    Parameters below;
    for (const auto& file : files) below.load(file);
    for (const auto& [key, text] : values) below.set(key, text);
    all.fill(below);
    return all;
  }

  void addValue(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw std::invalid_argument("--set: got '" + text + "', expected KEY=VALUE");
    }
    values.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
};

Handlers makeHandlers(ReplayCommand& command, GivenParameters& given) {
  const auto text = [](std::string& target) {
    return [&target](const std::string& value) { target = value; };
  };
  const auto number = [](const std::string& name, double& target) {
    return [name, &target](const std::string& value) { target = toNumber(name, value); };
  };
  return {
      {"--map", text(command.map)},
      {"--log", text(command.log.file)},
      {"--filter", [&](const auto& v) { given.own.set("filter", OptionValue(v)); }},
      {"--params", [&](const auto& v) { given.files.push_back(v); }},
      {"--set", [&](const auto& v) { given.addValue(v); }},
      {"--start", text(command.start)},
      {"--begin", number("--begin", command.log.begin)},
      {"--end", number("--end", command.log.end)},
      {"--seed", [&](const auto& v) { given.own.set("seed", toNumber("--seed", v)); }},
      {"--search", [&](const auto& v) { command.search = toCount("--search", v); }},
      {"--threads", [&](const auto& v) { given.own.set("threads", toNumber("--threads", v)); }},
      {"--scan-topic", text(command.log.scan_topic)},
      {"--odom-topic", text(command.log.odom_topic)},
      {"--truth-topic", text(command.log.truth_topic)},
      {"--truth", text(command.truth_file)},
      {"--trajectory", text(command.trajectory_file)},
      {"--json", text(command.json_file)},
      {"--plot", text(command.plot_file)},
  };
}

using Flags = std::map<std::string, bool*>;

Flags makeFlags(ReplayCommand& command) {
  return {{"--allow-misfit", &command.allows_misfit},
          {"--quiet", &command.is_quiet},
          {"--help", &command.wants_help},
          {"-h", &command.wants_help}};
}

[[noreturn]] void rejectArgument(const std::string& name, const Flags& flags,
                                 const Handlers& handlers) {
  std::vector<std::string> known;
  for (const auto& entry : flags) known.push_back(entry.first);
  for (const auto& entry : handlers) known.push_back(entry.first);
  throw std::invalid_argument("unknown argument '" + name + "'" + suggestion(name, known));
}

}  // namespace

std::string replayUsage() {
  return R"(usage: replay --map MAP.yaml --log FILE [options]

Drives a localizer through a recording (rosbag, or CARMEN log: plain, .gz, .bz2) as fast as it goes.

  --filter NAME           filter core
  --params FILE.yaml ...  parameters, the node's too; a later file wins
  --set KEY=VALUE ...     parameters one by one; win over the files
  --start truth | X,Y,YAW | global
                          where the robot starts: at the reference pose of the first scan used
                          (the default where there is a reference), at a pose (m, rad), anywhere
  --begin STAMP, --end STAMP
                          use only this part of the log
  --seed N, --threads N   of the filter
  --search N              no filter: N scans, spread over the log, are each looked for in the whole
                          map, and the answers compared with the reference
  --scan-topic T          laser scans; needed only if the bag has several such topics
  --odom-topic T          odometry from this topic rather than from /tf
  --truth-topic T         reference poses from the bag
  --truth FILE.tum        reference poses from a file
  --trajectory OUT.tum    write the estimate at every scan
  --json OUT.json         write the numbers
  --plot OUT.png          draw map, reference and estimate
  --allow-misfit          end with 0 though the scans do not fit the map: it is another one, say
  --quiet                 print nothing but warnings and errors
  --help                  print this
)";
}

ReplayCommand parseReplayCommand(const std::vector<std::string>& arguments) {
  ReplayCommand command;
  GivenParameters given;
  const Flags flags = makeFlags(command);
  const Handlers handlers = makeHandlers(command, given);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    if (const auto flag = flags.find(name); flag != flags.end()) {
      *flag->second = true;
      if (command.wants_help) return command;
      continue;
    }
    const auto handler = handlers.find(name);
    if (handler == handlers.end()) rejectArgument(name, flags, handlers);
    if (i + 1 == arguments.size() || isOption(arguments[i + 1])) {
      throw std::invalid_argument(name + " needs a value");
    }
    handler->second(arguments[++i]);
    const bool is_list = name == "--params" || name == "--set";
    while (is_list && i + 1 < arguments.size() && !isOption(arguments[i + 1])) {
      handler->second(arguments[++i]);
    }
  }
  checkRequired(command);
  command.parameters = given.layer();
  return command;
}

}  // namespace adaptive_localization
