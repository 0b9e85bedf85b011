// SPDX-License-Identifier: BSD-3-Clause
#include "eval/sonar_map_command.hpp"

#include <stdexcept>

#include "core/suggestion.hpp"
#include "eval/arguments.hpp"
#include "localizer/former_options.hpp"
#include "map/evidence_models.hpp"

namespace adaptive_localization {
namespace {

void addOption(const std::string& argument, Parameters& options) {
  const auto sign = argument.find(":=");
  if (sign == std::string::npos || sign == 0) {
    throw std::invalid_argument("got '" + argument + "', expected KEY:=VALUE");
  }
  options.set(argument.substr(0, sign), argument.substr(sign + 2));
}

std::vector<std::string> toModels(const std::string& name) {
  if (name == "all") return evidenceModels();
  for (const std::string& model : evidenceModels()) {
    if (model == name) return {model};
  }
  throw std::invalid_argument("--model: got '" + name +
                              "', expected all, moravec-elfes, elfes or konolige");
}

void setPoses(const std::string& name, SonarMapCommand& command) {
  command.poses = name == "odometry" ? Poses::kOdometry : Poses::kTruth;
  if (name != "odometry" && name != "truth") command.poses_file = name;
}

/// A robot with sonars, unless something else is said.
void readOptions(Parameters options, SonarMapCommand& command) {
  refuseFormerOptions(options);
  Parameters usual;
  usual.set("sonars", OptionValue{true});
  usual.set("lasers", OptionValue{0});
  options.fill(usual);
  command.simulation = SimulationOptions::from(options);
  command.evidence = options.read<EvidenceOptions>();
  command.log.frames = options.read<FrameOptions>();
  command.log.sonars = options.read<SonarTopics>();
  std::vector<std::string> known = keysOf(describe(command.simulation));
  for (const auto& rows :
       {describe(command.evidence), describe(command.log.frames), describe(command.log.sonars)}) {
    for (const auto& key : keysOf(rows)) known.push_back(key);
  }
  for (const auto& key : options.unknownKeys()) {
    throw std::invalid_argument("unknown option '" + key + "'" + suggestion(key, known));
  }
}

void check(const SonarMapCommand& command) {
  const bool is_bag = !command.log.file.empty();
  if (command.world.empty() && !is_bag && command.profile_file.empty()) {
    throw std::invalid_argument("--world or --bag is missing");
  }
  if (!command.world.empty() && is_bag) {
    throw std::invalid_argument("--world and --bag exclude each other");
  }
  if (!is_bag && (!command.poses_file.empty() || !command.log.truth_topic.empty())) {
    throw std::invalid_argument(command.poses_file.empty()
                                    ? "--truth-topic is of use with --bag alone"
                                    : "--poses: got '" + command.poses_file +
                                          "', expected truth or odometry");
  }
  const bool has_truth = !command.poses_file.empty() || !command.log.truth_topic.empty();
  if (is_bag && command.poses == Poses::kTruth && !has_truth) {
    throw std::invalid_argument(
        "--bag needs --truth-topic T, --poses FILE.tum or --poses odometry, to place readings by");
  }
}

}  // namespace

std::string sonarMapUsage() {
  std::string usage = R"(usage: sonar_map --world WORLD.yaml [options] [KEY:=VALUE ...]
       sonar_map --bag FILE.bag --truth-topic T sonar_topics:=T [options] [KEY:=VALUE ...]
       sonar_map --profile FILE.json [--model NAME] [KEY:=VALUE ...]

Drives a simulated robot with sonars through a world, or takes a recorded drive, and makes maps of
what they heard, by inverse models of Moravec and Elfes, of Elfes and of Konolige. Tells how good
they are where the true map is known: entropy in bits per cell, which cells are right, and
precision, recall and F-score of the occupied ones, a cell more or less. Only cells count of which
the true map knows what they are.

  --world WORLD.yaml  a floor plan or a map to drive in
  --seconds S         for so long (default 300)
  --seed N            of what is random in that (default 1)
  --bag FILE.bag      a recorded drive
  --truth-topic T     its topic with poses of base in the map
  --poses NAME        where the robot is taken to be: truth (default), odometry or, with --bag, a
                      trajectory FILE.tum
  --model NAME        moravec-elfes, elfes, konolige or all (default all)
  --resolution R      of the map, m per cell (default 0.05)
  --truth MAP.yaml    the true map (default: that of --world)
  --out DIR           write DIR/NAME/map.yaml, map.pgm and probability.pgm for each model and
                      DIR/maps.json; scripts/draw DIR/maps.json draws them side by side
  --json FILE         write the numbers
  --profile FILE.json write what readings of 1, 2, 3 m and so on tell of a cell, along the sonar's
                      axis and across it; scripts/draw FILE.json draws that
  --quiet             print nothing but errors
  --help              print this
  KEY:=VALUE          an option of the simulation (sonar_mirror_angle:=0.3, people:=3,
                      start:=random; p3dx_simulator --help lists them), of a bag (sonar_topics:=sonar,
                      sonar_frame_prefix, sonar_view, sonar_max_range, odom_frame_id,
                      base_frame_id) or of the models:

)";
  for (const auto& option : describe(EvidenceOptions{})) {
    usage += "  " + option.key + " (" + toText(option.value) +
             (option.unit.empty() ? "" : " " + option.unit) + "): " + option.sentence + '\n';
  }
  return usage;
}

SonarMapCommand parseSonarMapCommand(const std::vector<std::string>& arguments) {
  SonarMapCommand command;
  command.models = evidenceModels();
  Parameters options;
  ArgumentParser parser;
  parser.text("--world", command.world);
  parser.text("--bag", command.log.file);
  parser.text("--truth-topic", command.log.truth_topic);
  parser.text("--truth", command.truth);
  parser.text("--out", command.out_folder);
  parser.text("--json", command.json_file);
  parser.text("--profile", command.profile_file);
  parser.flag("--quiet", command.is_quiet);
  parser.option("--seconds", [&](const auto& v) {
    command.seconds = toNumber("--seconds", v, {0.1, 1e5}, "0.1 to 100000 seconds");
  });
  parser.option("--resolution", [&](const auto& v) {
    command.resolution = toNumber("--resolution", v, {0.005, 1.0}, "0.005 to 1 m");
  });
  parser.option("--seed",
                [&](const auto& v) { options.set("seed", OptionValue{toSeed("--seed", v)}); });
  parser.option("--model", [&](const auto& v) { command.models = toModels(v); });
  parser.option("--poses", [&](const auto& v) { setPoses(v, command); });
  parser.others([&](const auto& v) { addOption(v, options); });
  command.wants_help = !parser.parse(arguments);
  if (command.wants_help) return command;
  check(command);
  if (!command.world.empty()) options.set("world", OptionValue{command.world});
  readOptions(options, command);
  return command;
}

}  // namespace adaptive_localization
