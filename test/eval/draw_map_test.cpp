// SPDX-License-Identifier: BSD-3-Clause
// The program draw_map, by what it writes.
#include <gmock/gmock.h>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/map_spoiler.hpp"
#include "sim/rasterize.hpp"
#include "support/program.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

const std::string kWorld = std::string(SOURCE_DIR) + "/maps/maze/world.yaml";

class DrawMap : public testing::Test {
 protected:
  OccupancyGrid draw(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin() + (arguments.front() == kWorld ? 2 : 1),
                     folder_.file("drawn"));
    const ProgramResult result = runProgram(DRAW_MAP, arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return loadMap(folder_.file("drawn.yaml"));
  }

  static void expectRejected(const std::vector<std::string>& arguments, const std::string& why) {
    const ProgramResult result = runProgram(DRAW_MAP, arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, HasSubstr(why));
  }

  TempFolder folder_;
};

TEST_F(DrawMap, DrawsAFloorPlanAndSpoilsItIfAsked) {
  const OccupancyGrid plain = rasterize(loadFloorPlan(kWorld), 0.1);
  EXPECT_EQ(draw({kWorld, "0.1"}).cells(), plain.cells());
  EXPECT_EQ(draw({kWorld, "0.1", "--spoil", "thick:0.3", "gaps", "--spoil-seed", "7"}).cells(),
            spoil(spoil(plain, "thick", 0.3, 7), "gaps", 0.15, 7).cells());
}

TEST_F(DrawMap, SpoilsAnotherMap) {
  const OccupancyGrid plain = rasterize(loadFloorPlan(kWorld), 0.1);
  saveMap(plain, folder_.file("plain"));
  const OccupancyGrid drawn = draw({folder_.file("plain.yaml"), "--spoil", "shift:0.5"});
  EXPECT_EQ(drawn.cells(), plain.cells());
  EXPECT_NEAR(drawn.lattice().origin().x, plain.lattice().origin().x + 0.5, 1e-9);
}

TEST_F(DrawMap, TakesTheNameOfTheYamlFileToo) {
  EXPECT_EQ(runProgram(DRAW_MAP, {kWorld, "0.1", folder_.file("maze.yaml")}).exit_code, 0);
  EXPECT_NO_THROW(loadMap(folder_.file("maze.yaml")));
  expectRejected({kWorld, "0.1", ""}, "MAP: got '', expected the name of a file");
  expectRejected({kWorld, "0.1", folder_.file("")}, "expected the name of a file");
}

TEST_F(DrawMap, ReplacesNothingThatItReads) {
  const std::string plan = folder_.write("office.yaml", readWhole(kWorld));
  expectRejected({plan, "0.1", folder_.file("office")}, "is the input '" + plan + "'");
  EXPECT_EQ(readWhole(plan), readWhole(kWorld));
  saveMap(rasterize(loadFloorPlan(kWorld), 0.1), folder_.file("plain"));
  const std::string image = readWhole(folder_.file("plain.pgm"));
  folder_.write("other.yaml", readWhole(folder_.file("plain.yaml")));
  for (const char* old : {"plain.yaml", "other.yaml"}) {
    expectRejected({folder_.file(old), folder_.file("plain"), "--spoil", "thick"},
                   "is the input '" + folder_.file("plain.pgm") + "'");
  }
  EXPECT_EQ(readWhole(folder_.file("plain.pgm")), image);
}

TEST_F(DrawMap, RefusesWhatItDoesNotKnow) {
  expectRejected({"one"}, "draw_map: got 1 file names and numbers, expected two or three");
  expectRejected({kWorld, "tiny", "/tmp/x"}, "RESOLUTION: got 'tiny', expected a number");
  expectRejected({"a.yaml", "b", "--spoil", "slip"}, "damage: got 'slip', expected one of thick");
  expectRejected({"a.yaml", "b", "--spoil", "thick:99"}, "got 99, expected 0.001 to 10 m");
  expectRejected({"/none.yaml", "b"}, "draw_map: map file '/none.yaml' cannot be opened");
}

}  // namespace
}  // namespace adaptive_localization
