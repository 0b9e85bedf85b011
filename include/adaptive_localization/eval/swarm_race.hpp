// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace adaptive_localization {

struct SwarmRaceRun {
  int iterations{0};  // all that there are of a run that failed
  bool is_reached{false};
};

/// A way to search on a test function with so many searchers, over seeds.
struct SwarmRaceCell {
  std::string function, move;
  int searchers{0};
  std::vector<SwarmRaceRun> runs;

  int found() const;
  double iterations() const;  // mean
};

/// Experiment E7: who gets how fast to the least value of Rastrigin, Ackley and Eggcrate on a
/// torus, to a hundredth, within 500 iterations, and then of the same three turned and shifted. All
/// moves start from the same positions.
std::vector<SwarmRaceCell> raceSwarms(int seeds, int first_seed = 1);

/// In Markdown: a row for each function and move, a column for each number of searchers.
std::string toTable(const std::vector<SwarmRaceCell>& cells);

/// All runs. Throws std::runtime_error naming the file that could not be written.
void saveJson(const std::vector<SwarmRaceCell>& cells, const std::string& file);

/// A panel for each function, three side by side: iterations over searchers.
/// Throws std::runtime_error naming the file that could not be written.
void savePlot(const std::vector<SwarmRaceCell>& cells, const std::string& file);

}  // namespace adaptive_localization
