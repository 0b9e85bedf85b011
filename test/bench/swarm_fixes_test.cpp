// SPDX-License-Identifier: BSD-3-Clause
#include "bench/swarm_fixes.hpp"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace adaptive_localization {

TEST(SwarmFixes, MoreBatsFindMoreAndTheImprovedFormNeedsFewerIterations) {
  SwarmFixPlan plan;
  plan.world = SOURCE_DIR "/maps/simple/world.yaml";
  plan.resolution = 0.1;
  plan.runs = 6;
  plan.searchers = {20, 2000};
  plan.starts = {"free", "places"};
  plan.filters = {"amcl", "lbba", "mcl/fp"};
  std::map<std::string, SwarmFixCell> cells;
  for (const auto& cell : raceFixes(plan)) {
    ASSERT_EQ(cell.runs.size(), 6u);
    EXPECT_LE(cell.meanIterations(), 500.0);
    for (const SwarmFixRun& run : cell.runs) {
      EXPECT_EQ(run.is_reached, run.cost <= 0.03) << cell.core << ", seed " << run.seed;
      EXPECT_TRUE(run.error_mm < 150.0 || !run.is_found);
      EXPECT_GT(run.ms, 0.0);
    }
    cells[cell.start + "/" + cell.core + "/" + std::to_string(cell.searchers)] = cell;
  }
  EXPECT_EQ(cells.size(), 34u);
  const SwarmFixCell& many = cells["free/lbba improved/2000"];
  EXPECT_GE(many.found(), cells["free/lbba improved/20"].found());
  EXPECT_GE(many.found(), 4);
  EXPECT_LT(many.meanIterations(), cells["free/ba, right sign/2000"].meanIterations());
  EXPECT_GE(cells["places/lbba improved/2000"].found(), 5);
  for (const SwarmFixRun& run : cells["places/lbba improved/2000"].foundRuns())
    EXPECT_LT(run.matched_mm, 25.0);
  EXPECT_GE(cells["its own/amcl/2000"].found(), 3);
  EXPECT_GE(cells["its own/lbba/2000"].found(), 5);
}

/// Walls of cells are drawn to a tenth of a metre here.
TEST(SwarmFixes, ByLinesAreNearerThanByCells) {
  SwarmFixPlan plan;
  plan.world = SOURCE_DIR "/maps/simple/world.yaml";
  plan.resolution = 0.1;
  plan.noise = 0.0;
  plan.runs = 4;
  plan.searchers = {1000};
  plan.starts = {};
  plan.filters = {"lbba/seed"};
  plan.updates = 1;
  plan.options.set("swarm_tolerance", OptionValue(0.003));
  plan.options.set("swarm_max_iterations", OptionValue(200));
  const auto meanError = [&plan] {
    double sum = 0.0;
    const SwarmFixCell cell = raceFixes(plan).front();
    EXPECT_GE(cell.found(), 2);
    for (const SwarmFixRun& run : cell.foundRuns()) sum += run.error_mm / cell.found();
    return sum;
  };
  const double by_cells = meanError();
  plan.options.set("swarm_ranges", std::string("lines"));
  EXPECT_LT(meanError(), 0.5 * by_cells);
  plan.options.set("swarm_bees", std::string("9"));
  EXPECT_THROW(raceFixes(plan), std::invalid_argument);
}

TEST(SwarmFixes, AreKeptRunByRun) {
  const TempFolder folder;
  const SwarmFixRun run{7, 12, 0.025, true, true, 30.5, 4.5, 1.25};
  saveJson({{"free", "pso", 20, {run}}}, folder.file("fixes.json"));
  const auto json = nlohmann::json::parse(readWhole(folder.file("fixes.json")));
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0]["core"], "pso");
  EXPECT_EQ(json[0]["runs"][0], (nlohmann::json{{"seed", 7},
                                                {"iterations", 12},
                                                {"cost", 0.025},
                                                {"is_reached", true},
                                                {"is_found", true},
                                                {"error_mm", 30.5},
                                                {"matched_mm", 4.5},
                                                {"ms", 1.25}}));
  EXPECT_THROW(saveJson(std::vector<SwarmFixCell>{}, "/nosuch/fixes.json"), std::runtime_error);
}

TEST(SwarmFixes, NameTheWorldOrStartThatIsNotThere) {
  SwarmFixPlan plan;
  plan.world = "nosuch.yaml";
  EXPECT_THROW(raceFixes(plan), std::invalid_argument);
  plan.world = SOURCE_DIR "/maps/simple/world.yaml";
  plan.resolution = 0.2;
  plan.starts = {"nowhere"};
  EXPECT_THROW(raceFixes(plan), std::invalid_argument);
  plan.starts = {"free"};
  plan.swarms = {"bees"};
  EXPECT_THROW(raceFixes(plan), std::invalid_argument);
}

}  // namespace adaptive_localization
