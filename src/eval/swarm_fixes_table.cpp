// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "adaptive_localization/eval/statistics.hpp"
#include "adaptive_localization/eval/swarm_fixes.hpp"

namespace adaptive_localization {
namespace {

/// Nothing where nobody was found.
std::string errorsOf(const SwarmFixCell& cell) {
  if (cell.found == 0) return "| |";
  char text[100];
  std::snprintf(text, sizeof text, "| %.1f | %.1f ± %.1f", cell.error_mm, cell.matched_mm,
                cell.matched_std_mm);
  return text;
}

std::string rowOf(const SwarmFixCell& cell) {
  char row[300];
  std::snprintf(row, sizeof row, "| %s | %s | %d | %.0f | %.0f | %.1f %s | %.2f | %.2f |\n",
                cell.start.c_str(), cell.core.c_str(), cell.searchers,
                100.0 * cell.found / cell.runs, 100.0 * cell.reached / cell.runs,
                cell.meanIterations(), errorsOf(cell).c_str(), cell.ms_median, cell.ms_mean);
  return row;
}

/// The improved leaders against the bats with the right sign, as far as both are there.
std::string comparison(const std::vector<SwarmFixCell>& cells) {
  std::string text;
  for (const SwarmFixCell& leaders : cells) {
    for (const SwarmFixCell& bats : cells) {
      if (leaders.core != "lbba improved" || bats.core != "ba, right sign") continue;
      if (leaders.start != bats.start || leaders.searchers != bats.searchers) continue;
      char row[200];
      std::snprintf(row, sizeof row, "| %s | %d | %.1f | %.1f | %.2g | %.2g |\n",
                    leaders.start.c_str(), leaders.searchers, leaders.meanIterations(),
                    bats.meanIterations(),
                    signedRankTestOfLess(leaders.iterations, bats.iterations),
                    signTestOfLess(leaders.iterations, bats.iterations));
      text += row;
    }
  }
  if (text.empty()) return text;
  return "\n| start | searchers | iterations of lbba improved | of ba, right sign | p, signed "
         "ranks "
         "| p, signs |\n|---|---|---|---|---|---|\n" +
         text;
}

}  // namespace

std::string toTable(const std::vector<SwarmFixCell>& cells) {
  std::string table =
      "| start | core | searchers | found, % | reached 3 %, % | iterations | error of those found, "
      "mm "
      "| the same matched, mm | ms per fix: median | mean |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const SwarmFixCell& cell : cells) table += rowOf(cell);
  return table + comparison(cells);
}

}  // namespace adaptive_localization
