// SPDX-License-Identifier: BSD-3-Clause
// Draws the map of a floor plan, or a map anew, and makes it poor if asked to.
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/arguments.hpp"
#include "eval/map_spoiler.hpp"
#include "eval/outputs.hpp"
#include "eval/program.hpp"
#include "eval/spoil.hpp"
#include "sim/rasterize.hpp"

namespace adaptive_localization {
namespace {

struct DrawCommand {
  std::vector<std::string> words;  // WORLD.yaml RESOLUTION MAP, or OLD.yaml MAP
  std::vector<Spoil> spoils;
  int spoil_seed{1};
  bool wants_help{false};
};

std::string usage() {
  return R"(usage: draw_map WORLD.yaml RESOLUTION MAP [options]
       draw_map OLD.yaml MAP [options]

Writes MAP.pgm and MAP.yaml from a floor plan, RESOLUTION in metres per cell, or from another map.

  --spoil KIND[:AMOUNT] ...  make the map poor, in this order
  --spoil-seed N             of what is random in that (default 1)
  --help                     print this

Kinds of damage, with their usual amounts:
)" + describeKinds(kindsOf(mapDamages()));
}

Spoil parseMapSpoil(const std::string& text) {
  const Spoil spoil = parseSpoil(text);
  findKind(kindsOf(mapDamages()), spoil.kind);  // those of logs are of no use here
  return spoil;
}

DrawCommand parse(const std::vector<std::string>& arguments) {
  DrawCommand command;
  ArgumentParser parser;
  parser.others([&](const auto& v) { command.words.push_back(v); });
  parser.list("--spoil", [&](const auto& v) { command.spoils.push_back(parseMapSpoil(v)); });
  parser.option("--spoil-seed",
                [&](const auto& v) { command.spoil_seed = toSeed("--spoil-seed", v); });
  command.wants_help = !parser.parse(arguments);
  const std::size_t words = command.words.size();
  if (command.wants_help || words == 2 || words == 3) return command;
  throw std::invalid_argument("got " + std::to_string(words) +
                              " file names and numbers, expected two or three");
}

/// What to write, without an ending; that of a map's YAML file may be given.
std::string baseOf(const std::string& name) {
  std::filesystem::path base(name);
  if (base.extension() == ".yaml") base.replace_extension();
  if (base.has_filename()) return base.string();
  throw std::invalid_argument("MAP: got '" + name + "', expected the name of a file");
}

void draw(const DrawCommand& command) {
  const std::string& source = command.words.front();
  const std::string base = baseOf(command.words.back());
  const bool is_map = command.words.size() == 2;
  checkOutputs(filesToSave(base), is_map ? filesOfMap(source) : std::vector{source});
  OccupancyGrid map =
      is_map ? loadMap(source)
             : rasterize(loadFloorPlan(source), toNumber("RESOLUTION", command.words[1], kPositive,
                                                         "a number from 1e-06 to 1e+06, in m"));
  saveMap(spoil(std::move(map), command.spoils, static_cast<std::uint64_t>(command.spoil_seed)),
          base);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  namespace al = adaptive_localization;
  return al::runProgram("draw_map", al::usage(), al::parse, al::draw, {argv + 1, argv + argc});
}
