// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "../ros/node_options.hpp"
#include "adaptive_localization/map/map_io.hpp"
#include "core/audience.hpp"
#include "core/scan_timing.hpp"
#include "core/suggestion.hpp"
#include "eval/log_reader.hpp"
#include "eval/log_spoiler.hpp"
#include "eval/outputs.hpp"
#include "eval/program.hpp"
#include "eval/progress_bar.hpp"
#include "eval/replay_command.hpp"
#include "eval/report.hpp"
#include "eval/search_run.hpp"
#include "eval/start.hpp"
#include "localizer/untuned.hpp"
#include "observation/landmark_model.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kViews = 60;  // of a report

void warn(const std::vector<std::string>& warnings) {
  for (const auto& warning : warnings) std::cerr << "replay: warning: " << warning << '\n';
}

/// All options that have a say here.
std::vector<std::string> knownKeys(const Localizer& localizer) {
  std::vector<std::string> keys = keysOf(localizer.allOptions());
  for (const auto& rows :
       {describe(FrameOptions{}), describe(ScanTiming{}), describe(HeadingTopics{}),
        describe(SonarTopics{}), describe(LandmarkTopics{}), describe(StartOptions{})}) {
    for (const auto& key : keysOf(rows)) keys.push_back(key);
  }
  return keys;
}

/// The node's parameters, and amcl's, may be in the same file.
bool isOfNode(const std::string& key) {
  const auto of_node = keysOf(describe(NodeOptions{}));
  return std::count(of_node.begin(), of_node.end(), key) > 0 || audienceOf(key) == Audience::kAmcl;
}

/// Says which parameters nobody reads: the node's own in one line, others, perhaps misspelt, each.
void reportUnused(const ReplayCommand& command, const Localizer& localizer) {
  const auto here = command.parameters.unknownKeys();
  std::string of_node;
  for (const auto& key : localizer.unknownKeys()) {
    if (!std::count(here.begin(), here.end(), key)) continue;
    if (isOfNode(key)) {
      of_node += " " + key;
    } else {
      warn({"unknown parameter '" + key + "'" + suggestion(key, knownKeys(localizer))});
    }
  }
  if (of_node.empty() || command.is_quiet) return;
  std::cerr << "replay: parameters of the node that have no effect here:" << of_node << '\n';
}

Log readLog(const ReplayCommand& command) {
  LogRequest request = command.log;
  request.frames = command.parameters.read<FrameOptions>();
  request.headings = command.parameters.read<HeadingTopics>();
  request.sonars = command.parameters.read<SonarTopics>();
  request.landmarks = command.parameters.read<LandmarkTopics>();
  request.has_intensities = command.parameters.read<ScanOptions>().reflector_intensity > 0.0;
  request.landmark_map = knownLandmarks(command.parameters.read<LandmarkOptions>());
  Log log = adaptive_localization::readLog(request);
  if (!command.truth_file.empty()) setReference(loadTum(command.truth_file, log.warnings), log);
  for (LogScan& scan : log.scans) {
    if (command.T_base_laser) scan.mount = LaserMount::level(*command.T_base_laser);
  }
  return log;
}

std::vector<StampedPose> estimates(const RunRecord& run) {
  std::vector<StampedPose> poses;
  for (const auto& step : run.steps) poses.push_back({step.stamp, step.T_map_base});
  return poses;
}

/// What scripts/report makes a page of.
void writeReport(const std::string& folder, const RunDescription& description,
                 const OccupancyGrid& map, const RunRecord& run, const Metrics& metrics) {
  std::error_code ignored;  // it shows at the first file
  std::filesystem::create_directories(folder, ignored);
  saveMap(map, folder + "/map");
  saveScans(run, folder + "/scans.csv");
  saveJson(toJson(run.views), folder + "/views.json");
  saveJson(toJson(description, metrics), folder + "/run.json");
}

void writeResults(const ReplayCommand& command, const RunDescription& description,
                  const OccupancyGrid& map, const RunRecord& run, const Metrics& metrics) {
  if (!command.trajectory_file.empty()) saveTum(estimates(run), command.trajectory_file);
  if (!command.json_file.empty()) saveJson(toJson(description, metrics), command.json_file);
  if (!command.report_folder.empty()) {
    writeReport(command.report_folder, description, map, run, metrics);
  }
  if (!command.is_quiet) std::cout << summarize(description, metrics) << '\n';
}

void checkFiles(const ReplayCommand& command) {
  std::vector<std::string> inputs = filesOfMap(command.map), outputs;
  inputs.insert(inputs.end(), {command.log.file, command.truth_file});
  inputs.insert(inputs.end(), command.parameter_files.begin(), command.parameter_files.end());
  outputs = {command.trajectory_file, command.json_file};
  if (!command.report_folder.empty()) {
    const auto map = filesToSave(command.report_folder + "/map");
    outputs.insert(outputs.end(), map.begin(), map.end());
  }
  checkOutputs(outputs, inputs);
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

void checkFit(const ReplayCommand& command, const Metrics& metrics) {
  if (!isMisfit(metrics) || command.allows_misfit) return;
  std::ostringstream text;
  text << "the scans do not fit the map '" << command.map << "'"
       << (command.spoils.empty() ? "" : ", spoiled by " + toText(command.spoils))
       << ": no place explains " << std::lround(100.0 * metrics.nowhere_share)
       << " % of those that were looked at; is it the map of this building, is the robot on it, is "
          "the laser's mount right? --allow-misfit takes that as it is";
  throw std::runtime_error(text.str());
}

void replay(const ReplayCommand& asked) {
  ReplayCommand command = asked;
  const TunedParameters given = tuned(asked.parameters);
  if (!given.remark.empty() && !command.is_quiet) std::cerr << "replay: " << given.remark << '\n';
  command.parameters = given.parameters;
  checkFiles(command);
  OccupancyGrid good_map = loadMap(command.map);
  const auto spoil_seed = static_cast<std::uint64_t>(
      command.spoil_seed.value_or(command.parameters.read<LocalizerOptions>().seed));
  const auto map =
      std::make_shared<const OccupancyGrid>(spoil(std::move(good_map), command.spoils, spoil_seed));
  Localizer localizer(command.parameters, map);
  Log log = spoil(readLog(command), command.spoils, spoil_seed);
  const double offset = command.parameters.read<ScanTiming>().scan_time_offset;
  if (offset != 0.0) log = restamped(std::move(log), offset);
  if (offset != 0.0 && log.scans.empty()) {
    throw std::invalid_argument("option 'scan_time_offset': got " + std::to_string(offset) +
                                ", expected one that leaves a scan with odometry");
  }
  const Prior prior = startPrior(command.start, command.parameters.read<StartOptions>(), log);
  checkStart(command.start, prior, *map);
  warn(log.warnings);
  reportUnused(command, localizer);
  if (command.search > 0) return search(command, localizer, log);
  localizer.reset(prior);

  RunRecord run;
  {
    ProgressBar bar(log.scans.size(), !command.is_quiet);
    const std::size_t views = command.report_folder.empty() ? 0 : kViews;
    run = runLog(
        log, localizer, [&bar](std::size_t done) { bar.show(done); }, views);
  }
  warn(run.warnings);
  const LocalizerOptions& options = localizer.options();
  const Metrics metrics = measure(run);
  writeResults(command,
               {command.log.file, command.map, options.filter, options.seed, options.threads,
                startText(command.start, prior), toText(command.spoils), spoil_seed,
                log.scans.front().mount},
               *map, run, metrics);
  checkFit(command, metrics);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("replay", al::replayUsage(), al::parseReplayCommand, al::replay,
                        {argv + 1, argv + argc});
}
