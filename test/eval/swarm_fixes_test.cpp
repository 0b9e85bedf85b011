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
  std::map<std::string, SwarmFixCell> cells;
  for (const auto& cell : raceFixes(plan)) {
    EXPECT_EQ(cell.runs, 6);
    EXPECT_LE(cell.iterations, 500.0);
    EXPECT_LT(cell.error_mm, 150.0);
    cells[cell.move + "/" + std::to_string(cell.searchers)] = cell;
  }
  EXPECT_EQ(cells.size(), 10u);
  EXPECT_GE(cells["lbba improved/2000"].found, cells["lbba improved/20"].found);
  EXPECT_GE(cells["lbba improved/2000"].found, 5);
  EXPECT_LT(cells["lbba improved/2000"].iterations, cells["ba, right sign/2000"].iterations);
  EXPECT_THAT(toTable({{"pso", 20, 4, 3, 2, 12.4, 56.78, 1.234}}),
              testing::HasSubstr("| pso | 20 | 75 | 50 | 12 | 56.8 | 1.23 |"));
}

TEST(SwarmFixes, NameTheWorldThatIsNotThere) {
  SwarmFixPlan plan;
  plan.world = "nosuch.yaml";
  EXPECT_THROW(raceFixes(plan), std::invalid_argument);
}

}  // namespace adaptive_localization
