// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/experiment_command.hpp"

#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>
#include <thread>

#include "adaptive_localization/core/suggestion.hpp"

namespace adaptive_localization {
namespace {

int toCount(const std::string& name, const std::string& text, long most = 1000000) {
  char* end = nullptr;
  const long number = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || number < 1 || number > most) {
    throw std::invalid_argument(name + ": got '" + text + "', expected a whole number from 1 to " +
                                std::to_string(most));
  }
  return static_cast<int>(number);
}

Shard toShard(const std::string& text) {
  const auto slash = text.find('/');
  if (slash != std::string::npos) {
    try {
      const int count = toCount("", text.substr(slash + 1));
      const int index = toCount("", text.substr(0, slash), count);
      return {static_cast<std::size_t>(index), static_cast<std::size_t>(count)};
    } catch (const std::invalid_argument&) {  // said better below
    }
  }
  throw std::invalid_argument("--shard: got '" + text + "', expected i/n with i from 1 to n");
}

bool isOption(const std::string& argument) {
  return argument.compare(0, 2, "--") == 0;
}

bool addOverride(const std::string& argument, Overrides& overrides) {
  const auto sign = argument.find(":=");
  if (sign == std::string::npos || sign == 0) return false;
  overrides.emplace_back(argument.substr(0, sign), argument.substr(sign + 2));
  return true;
}

void check(const ExperimentCommand& command) {
  if (command.files.empty()) throw std::invalid_argument("no file is given");
  if (command.is_summary && !command.out_file.empty()) {
    throw std::invalid_argument("--summary and --out exclude each other");
  }
  if (!command.is_summary && !command.is_list && command.out_file.empty()) {
    throw std::invalid_argument("--out is missing");
  }
}

}  // namespace

std::string experimentUsage() {
  return R"(usage: experiments EXPERIMENT.yaml ... --out RESULTS.jsonl [options] [KEY:=VALUE ...]
       experiments --summary RESULTS.jsonl ... [--json FILE] [--plot FILE]

Drives simulated robots through experiments, in parallel, and writes one JSON line per run. Runs
that RESULTS.jsonl holds already are not made again: after an interruption, say the same again.

  --out RESULTS.jsonl  where the results go
  --jobs N             runs at the same time (default: as many as there are processors)
  --shard I/N          only part I of N, for several machines; their results merge by concatenation
  --seeds N            seeds for each case and core, rather than the file's number
  --only WORD          only runs with this in experiment/case/core; may be given several times
  KEY:=VALUE           overrides what the file says (duration:=20, simulation.people:=3,
                       success.position:=0.3), or else an option of all cores (laser_max_beams:=30)
  --list               print what would be run
  --summary            summarize files of results, and run nothing
  --json FILE          write the summary
  --plot FILE.png      draw which share of the robots was found after which time
  --quiet              print nothing but errors
  --help               print this
)";
}

ExperimentCommand parseExperimentCommand(const std::vector<std::string>& arguments) {
  ExperimentCommand command;
  command.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const std::map<std::string, bool*> flags{{"--summary", &command.is_summary},
                                           {"--list", &command.is_list},
                                           {"--quiet", &command.is_quiet},
                                           {"--help", &command.wants_help},
                                           {"-h", &command.wants_help}};
  const std::map<std::string, std::function<void(const std::string&)>> handlers{
      {"--out", [&](const auto& v) { command.out_file = v; }},
      {"--json", [&](const auto& v) { command.json_file = v; }},
      {"--plot", [&](const auto& v) { command.plot_file = v; }},
      {"--jobs", [&](const auto& v) { command.jobs = toCount("--jobs", v, 1024); }},
      {"--shard", [&](const auto& v) { command.shard = toShard(v); }},
      {"--seeds", [&](const auto& v) { command.seeds = toCount("--seeds", v); }},
      {"--only", [&](const auto& v) { command.words.push_back(v); }},
  };
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    if (const auto flag = flags.find(name); flag != flags.end()) {
      *flag->second = true;
      if (command.wants_help) return command;
    } else if (const auto handler = handlers.find(name); handler != handlers.end()) {
      if (i + 1 == arguments.size() || isOption(arguments[i + 1])) {
        throw std::invalid_argument(name + " needs a value");
      }
      handler->second(arguments[++i]);
    } else if (isOption(name)) {
      throw std::invalid_argument("unknown argument '" + name + "'" + suggestion(name, handlers));
    } else if (!addOverride(name, command.overrides)) {
      command.files.push_back(name);
    }
  }
  check(command);
  return command;
}

}  // namespace adaptive_localization
