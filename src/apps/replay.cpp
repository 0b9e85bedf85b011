// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/eval/plot.hpp"
#include "adaptive_localization/eval/progress_bar.hpp"
#include "adaptive_localization/eval/replay_command.hpp"
#include "adaptive_localization/eval/report.hpp"
#include "adaptive_localization/eval/search_run.hpp"
#include "adaptive_localization/eval/start.hpp"
#include "adaptive_localization/map/map_io.hpp"

namespace adaptive_localization {
namespace {

void warn(const std::vector<std::string>& warnings) {
  for (const auto& warning : warnings) std::cerr << "replay: warning: " << warning << '\n';
}

/// Keys that neither the localizer nor the replayer knows.
std::vector<std::string> unknownKeys(const Localizer& localizer, const Parameters& parameters) {
  const auto here = parameters.unknownKeys();
  std::vector<std::string> unknown;
  for (const auto& key : localizer.unknownKeys()) {
    if (std::count(here.begin(), here.end(), key)) unknown.push_back(key);
  }
  return unknown;
}

Log readLog(const ReplayCommand& command) {
  LogRequest request = command.log;
  request.frames = command.parameters.read<FrameOptions>();
  Log log = adaptive_localization::readLog(request);
  if (!command.truth_file.empty()) setReference(loadTum(command.truth_file, log.warnings), log);
  return log;
}

std::vector<StampedPose> estimates(const RunRecord& run) {
  std::vector<StampedPose> poses;
  for (const auto& step : run.steps) poses.push_back({step.stamp, step.T_map_base});
  return poses;
}

void writeResults(const ReplayCommand& command, const RunDescription& description,
                  const OccupancyGrid& map, const RunRecord& run) {
  const Metrics metrics = measure(run);
  if (!command.trajectory_file.empty()) saveTum(estimates(run), command.trajectory_file);
  if (!command.json_file.empty()) saveJson(toJson(description, metrics), command.json_file);
  if (!command.plot_file.empty()) savePlot(map, run, metrics, command.plot_file);
  if (!command.is_quiet) std::cout << summarize(description, metrics) << '\n';
}

void search(const ReplayCommand& command, const Localizer& localizer, const Log& log) {
  SearchMetrics metrics;
  {
    ProgressBar bar(static_cast<std::size_t>(command.search), !command.is_quiet);
    metrics = searchLog(log, localizer.places(), localizer.scanOptions(), command.search,
                        [&bar](std::size_t done) { bar.show(done); });
  }
  if (!command.json_file.empty()) saveJson(toJson(metrics), command.json_file);
  if (!command.is_quiet) std::cout << summarize(metrics) << '\n';
}

void replay(const ReplayCommand& command) {
  const auto map = std::make_shared<const OccupancyGrid>(loadMap(command.map));
  Localizer localizer(command.parameters, map);
  Log log = readLog(command);
  const Prior prior = startPrior(command.start, command.parameters.read<StartOptions>(), log);
  warn(log.warnings);
  for (const auto& key : unknownKeys(localizer, command.parameters)) {
    warn({"unknown parameter '" + key + "'"});
  }
  if (command.search > 0) return search(command, localizer, log);
  localizer.reset(prior);

  RunRecord run;
  {
    ProgressBar bar(log.scans.size(), !command.is_quiet);
    run = runLog(log, localizer, [&bar](std::size_t done) { bar.show(done); });
  }
  warn(run.warnings);
  const LocalizerOptions& options = localizer.options();
  writeResults(command,
               {command.log.file, command.map, options.filter, options.seed, options.threads}, *map,
               run);
}

}  // namespace

int runReplay(const std::vector<std::string>& arguments) {
  ReplayCommand command;
  try {
    command = parseReplayCommand(arguments);
  } catch (const std::exception& error) {
    std::cerr << "replay: " << error.what() << "\n\n" << replayUsage();
    return 1;
  }
  if (command.wants_help) {
    std::cout << replayUsage();
    return 0;
  }
  try {
    replay(command);
  } catch (const std::exception& error) {
    std::cerr << "replay: " << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace adaptive_localization

int main(int argc, char** argv) {
  return adaptive_localization::runReplay({argv + 1, argv + argc});
}
