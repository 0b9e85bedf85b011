// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/swarm_fixes.hpp"

#include <gmock/gmock.h>

#include <map>

namespace adaptive_localization {

TEST(SwarmFixes, MoreBatsFindMoreAndTheImprovedFormNeedsFewerIterations) {
  SwarmFixPlan plan;
  plan.world = SOURCE_DIR "/maps/simple/world.yaml";
  plan.resolution = 0.1;
  plan.runs = 6;
  plan.searchers = {20, 2000};
  plan.starts = {"free", "places"};
  plan.filters = {"amcl", "lbba"};
  std::map<std::string, SwarmFixCell> cells;
  for (const auto& cell : raceFixes(plan)) {
    ASSERT_EQ(cell.iterations.size(), 6u);
    EXPECT_LE(cell.meanIterations(), 500.0);
    EXPECT_LT(cell.error_mm, 150.0);
    EXPECT_GT(cell.ms_mean, 0.0);
    cells[cell.start + "/" + cell.core + "/" + std::to_string(cell.searchers)] = cell;
  }
  EXPECT_EQ(cells.size(), 32u);
  const SwarmFixCell& many = cells["free/lbba improved/2000"];
  EXPECT_GE(many.found, cells["free/lbba improved/20"].found);
  EXPECT_GE(many.found, 4);
  EXPECT_LT(many.meanIterations(), cells["free/ba, right sign/2000"].meanIterations());
  EXPECT_GE(cells["places/lbba improved/2000"].found, 5);
  EXPECT_LT(cells["places/lbba improved/2000"].matched_mm, 15.0);
  EXPECT_GE(cells["its own/amcl/2000"].found, 3);
  EXPECT_GE(cells["its own/lbba/2000"].found, 5);
}

TEST(SwarmFixes, AreToldInATable) {
  const std::string table = toTable(
      {{"ser", "lbba improved", 20, 4, 2, 3, {1, 2, 3, 3}, 56.78, 4.56, 0.71, 1.06, 1.234, 5.678},
       {"ser", "ba, right sign", 20, 4, 1, 1, {9, 9, 9, 4}, 60.0, 5.0, 1.0, 2.6, 2.0, 3.0}});
  EXPECT_THAT(
      table,
      testing::HasSubstr(
          "| ser | lbba improved | 20 | 75 | 50 | 2.2 | 56.8 | 4.6 / 1.1 / 0.7 | 1.23 | 5.68 |"));
  EXPECT_THAT(table, testing::HasSubstr("| ser | 20 | 2.2 | 7.8 | 0.05 | 0.062 |"));
}

TEST(SwarmFixes, NoErrorIsToldWhereNobodyWasFound) {
  const std::string table =
      toTable({{"free", "pso", 20, 2, 0, 0, {500, 500}, 0.0, 0.0, 0.0, 0.0, 1.0, 1.5}});
  EXPECT_THAT(table, testing::HasSubstr("| free | pso | 20 | 0 | 0 | 500.0 | | | 1.00 | 1.50 |"));
}

TEST(SwarmFixes, NameTheWorldOrStartThatIsNotThere) {
  SwarmFixPlan plan;
  plan.world = "nosuch.yaml";
  EXPECT_THROW(raceFixes(plan), std::invalid_argument);
  plan.world = SOURCE_DIR "/maps/simple/world.yaml";
  plan.resolution = 0.2;
  plan.starts = {"nowhere"};
  EXPECT_THROW(raceFixes(plan), std::invalid_argument);
}

}  // namespace adaptive_localization
