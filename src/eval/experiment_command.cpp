// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_command.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "eval/arguments.hpp"

namespace adaptive_localization {
namespace {

constexpr int kMost = 1000000;

Shard toShard(const std::string& text) {
  const auto slash = text.find('/');
  if (slash != std::string::npos) {
    try {
      const int count = toCount("", text.substr(slash + 1), kMost);
      const int index = toCount("", text.substr(0, slash), count);
      return {static_cast<std::size_t>(index), static_cast<std::size_t>(count)};
    } catch (const std::invalid_argument&) {  // said better below
    }
  }
  throw std::invalid_argument("--shard: got '" + text + "', expected i/n with i from 1 to n");
}

bool addOverride(const std::string& argument, Overrides& overrides) {
  const auto sign = argument.find(":=");
  if (sign == std::string::npos || sign == 0) return false;
  overrides.emplace_back(argument.substr(0, sign), argument.substr(sign + 2));
  return true;
}

/// Here, named as the first experiment's file.
std::string resultsOf(const std::string& yaml_file) {
  return std::filesystem::path(yaml_file).stem().string() + ".jsonl";
}

}  // namespace

std::string experimentUsage() {
  return R"(usage: experiments EXPERIMENT.yaml ... [--out RESULTS.jsonl] [options] [KEY:=VALUE ...]

Drives simulated robots through experiments, in parallel, and writes one JSON line per run. Runs
that RESULTS.jsonl holds already are not made again: after an interruption, say the same again.
scripts/summarize RESULTS.jsonl makes tables and plots of them.

  --out RESULTS.jsonl  where the results go (default: here, in a file named as the first experiment's)
  --jobs N             runs at the same time (default: as many as there are processors)
  --shard I/N          only part I of N, for several machines; their results merge by concatenation
  --seeds N            seeds for each case and core, rather than the file's number
  --only WORD          only runs with this in experiment/case/core; may be given several times;
                       a $ at its end is the end: "/kld$" is kld, but not sa_kld
  KEY:=VALUE           overrides what the file says (duration:=20, simulation.people:=3,
                       success.position:=0.3), or else an option of all cores (laser_max_beams:=30)
  --list               print what would be run
  --quiet              print nothing but errors
  --help               print this
)";
}

ExperimentCommand parseExperimentCommand(const std::vector<std::string>& arguments) {
  ExperimentCommand command;
  command.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  ArgumentParser parser;
  parser.flag("--list", command.is_list);
  parser.flag("--quiet", command.is_quiet);
  parser.text("--out", command.out_file);
  parser.option("--jobs", [&](const auto& v) { command.jobs = toCount("--jobs", v, 1024); });
  parser.option("--shard", [&](const auto& v) { command.shard = toShard(v); });
  parser.option("--seeds", [&](const auto& v) { command.seeds = toCount("--seeds", v, kMost); });
  parser.option("--only", [&](const auto& v) { command.words.push_back(v); });
  parser.others([&](const auto& v) {
    if (!addOverride(v, command.overrides)) command.files.push_back(v);
  });
  command.wants_help = !parser.parse(arguments);
  if (command.wants_help) return command;
  if (command.files.empty()) throw std::invalid_argument("no file is given");
  if (command.out_file.empty()) command.out_file = resultsOf(command.files.front());
  return command;
}

}  // namespace adaptive_localization
