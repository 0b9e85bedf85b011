// SPDX-License-Identifier: BSD-3-Clause
#include "eval/replay_command.hpp"

#include <stdexcept>

#include "eval/arguments.hpp"
#include "eval/start.hpp"

namespace adaptive_localization {
namespace {

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

  void addValue(const std::string& text) { values.push_back(toKeyAndValue("--set", text)); }
};

ArgumentParser makeParser(ReplayCommand& command, GivenParameters& given) {
  const auto own = [&given](const std::string& key) {
    return [&given, key](const auto& v) { given.own.set(key, toNumber("--" + key, v)); };
  };
  ArgumentParser parser;
  parser.text("--map", command.map);
  parser.text("--log", command.log.file);
  parser.option("--filter", [&](const auto& v) { given.own.set("filter", OptionValue(v)); });
  parser.list("--params", [&](const auto& v) { given.files.push_back(v); });
  parser.list("--set", [&](const auto& v) { given.addValue(v); });
  parser.text("--start", command.start);
  parser.number("--begin", command.log.begin);
  parser.number("--end", command.log.end);
  parser.option("--seed", own("seed"));
  parser.option("--threads", own("threads"));
  parser.option("--search", [&](const auto& v) {
    command.search = toCount("--search", v, 1000000000, "a whole number from 1");
  });
  parser.list("--spoil", [&](const auto& v) { command.spoils.push_back(parseSpoil(v)); });
  parser.option("--spoil-seed",
                [&](const auto& v) { command.spoil_seed = toSeed("--spoil-seed", v); });
  parser.option("--mount", [&](const auto& v) {
    command.T_base_laser = toPose("--mount", v, "X,Y,YAW in m and rad");
  });
  parser.text("--scan-topic", command.log.scan_topic);
  parser.text("--odom-topic", command.log.odom_topic);
  parser.text("--truth-topic", command.log.truth_topic);
  parser.text("--truth", command.truth_file);
  parser.text("--trajectory", command.trajectory_file);
  parser.text("--json", command.json_file);
  parser.gone("--plot", "--report FOLDER, and scripts/report FOLDER");
  parser.text("--report", command.report_folder);
  parser.flag("--allow-misfit", command.allows_misfit);
  parser.flag("--quiet", command.is_quiet);
  return parser;
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
  --spoil KIND[:AMOUNT] ...
                          make map, odometry or scans poor first, in this order; the reference
                          stays as it is. The kinds are below
  --spoil-seed N          of what is random in that; otherwise the run's seed
  --mount X,Y,YAW         where a level laser sits on the robot (m, rad), whatever the log says
  --scan-topic T          laser scans; needed only if the bag has several such topics
  --odom-topic T          odometry from this topic rather than from /tf
  --truth-topic T         reference poses from the bag
  --truth FILE.tum        reference poses from a file
  --trajectory OUT.tum    write the estimate at every scan
  --json OUT.json         write the numbers
  --report FOLDER         keep the whole run there; scripts/report FOLDER makes a page of it, with
                          pictures
  --allow-misfit          end with 0 though the scans do not fit the map: it is another one, say
  --quiet                 print nothing but warnings and errors
  --help                  print this

Other senses that a bag has are heard, as by the node, where its parameters name their topics:
imu_topic, magnetic_field_topic, heading_topic, sonar_topics and, with a landmark_map,
landmark_topic; reflector_intensity finds reflectors of that map in the scans. For example

  --set landmark_topic=landmarks landmark_map=posts.yaml

Kinds of damage, with their usual amounts:
)" + describeKinds(damageKinds());
}

ReplayCommand parseReplayCommand(const std::vector<std::string>& arguments) {
  ReplayCommand command;
  GivenParameters given;
  command.wants_help = !makeParser(command, given).parse(arguments);
  if (command.wants_help) return command;
  checkRequired(command);
  command.parameters = given.layer();
  command.parameter_files = given.files;
  return command;
}

}  // namespace adaptive_localization
