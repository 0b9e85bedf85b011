// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/energy_command.hpp"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>

#include "adaptive_localization/core/suggestion.hpp"

namespace adaptive_localization {
namespace {

double readView(const std::string& text) {
  char* end = nullptr;
  const double view = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(view >= 1.0 && view <= 360.0)) {
    throw std::invalid_argument("--view: got '" + text + "', expected 1 to 360 degrees");
  }
  return view;
}

Pose2 readQuery(const std::string& text) {
  Pose2 pose;
  char rest{};
  const int read = std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &pose.x, &pose.y, &pose.theta, &rest);
  if (read != 3 || !isFinite(pose)) {
    throw std::invalid_argument("--query: got '" + text + "', expected X,Y,YAW in m and rad");
  }
  return pose;
}

}  // namespace

std::string energyUsage() {
  return R"(usage: energy_grid --map MAP.yaml [options]

Builds the energy grid of a map and tells what is in it.

  --beams N          beams that an energy is made of (default 30)
  --orientations N   headings in each cell (default 18)
  --max-range R      ranges are cut off here, m (default 10)
  --view DEG         what the laser sees, all round is 360 (default 180)
  --png FILE         draw the mean energy of each cell; with --query, the region of the scan
  --query X,Y,YAW    simulate a scan there (m, rad), find its region and the places it fits
  --help             print this
)";
}

EnergyCommand parseEnergyCommand(const std::vector<std::string>& arguments) {
  EnergyCommand command;
  using Handler = std::function<void(const std::string&)>;
  const auto option = [&](const char* key) {
    return [&command, key](const std::string& text) { command.options.set(key, text); };
  };
  const std::map<std::string, Handler> handlers{
      {"--map", [&](const std::string& text) { command.map = text; }},
      {"--png", [&](const std::string& text) { command.picture = text; }},
      {"--query", [&](const std::string& text) { command.query = readQuery(text); }},
      {"--view", [&](const std::string& text) { command.view = readView(text); }},
      {"--beams", option("energy_beams")},
      {"--orientations", option("energy_orientations")},
      {"--max-range", option("energy_max_range")}};
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    command.wants_help |= arguments[i] == "--help" || arguments[i] == "-h";
    if (command.wants_help) return command;
    const auto handler = handlers.find(arguments[i]);
    if (handler == handlers.end()) {
      throw std::invalid_argument("unknown argument '" + arguments[i] + "'" +
                                  suggestion(arguments[i], handlers));
    }
    if (++i == arguments.size()) throw std::invalid_argument(handler->first + " needs a value");
    handler->second(arguments[i]);
  }
  if (command.map.empty()) throw std::invalid_argument("--map is missing");
  return command;
}

}  // namespace adaptive_localization
