// SPDX-License-Identifier: BSD-3-Clause
// Experiment E20: how a Kalman filter's ellipse grows while it observes nothing, and what lines
// change about it.
#include "eval/line_drive.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "eval/arguments.hpp"
#include "eval/outputs.hpp"
#include "eval/program.hpp"
#include "eval/report.hpp"

namespace adaptive_localization {
namespace {

struct LineDriveCommand {
  LineDrivePlan plan;
  std::string json_file;
  bool wants_help{false};
};

std::string usage() {
  return R"(usage: line_drive WORLD.yaml [options]

Drives a simulated robot that knows its start along the route of a floor plan. Two Kalman filters
follow it: by odometry alone, and corrected by the straight lines in scans (ekf_icp with
ekf_landmarks: lines). Prints errors, deviations and the areas of their 99 % ellipses.

  --seconds N            of the drive (default 60)
  --json FILE            writes ways, covariances and the lines of the last scan, for scripts/draw
  --robot KEY=VALUE ...  options of the simulated robot, as p3dx_simulator --help lists them
  --set KEY=VALUE ...    options of ekf_icp, and of how scans are read
  --help                 print this
)";
}

ArgumentParser::Take into(Parameters& parameters, const std::string& name) {
  return [&parameters, name](const std::string& text) {
    const auto [key, value] = toKeyAndValue(name, text);
    parameters.set(key, value);
  };
}

LineDriveCommand parse(const std::vector<std::string>& arguments) {
  constexpr Range kSeconds{0.1, 86400.0};
  LineDriveCommand command;
  LineDrivePlan& plan = command.plan;
  ArgumentParser parser;
  parser.others([&](const auto& v) {
    if (!plan.world.empty()) throw std::invalid_argument("argument '" + v + "' is one too many");
    plan.world = v;
  });
  parser.option("--seconds", [&](const auto& v) {
    plan.duration = toNumber("--seconds", v, kSeconds, "0.1 to 86400 s");
  });
  parser.text("--json", command.json_file);
  parser.list("--robot", into(plan.robot, "--robot"));
  parser.list("--set", into(plan.options, "--set"));
  command.wants_help = !parser.parse(arguments);
  if (!command.wants_help && plan.world.empty()) {
    throw std::invalid_argument("WORLD.yaml is missing");
  }
  return command;
}

void run(const LineDriveCommand& command) {
  checkOutputs({command.json_file}, {command.plan.world});
  const LineDrive drive = driveByLines(command.plan);
  std::fputs(toTable(drive).c_str(), stdout);
  if (!command.json_file.empty()) saveJson(toJson(drive), command.json_file);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("line_drive", al::usage(), al::parse, al::run, {argv + 1, argv + argc});
}
