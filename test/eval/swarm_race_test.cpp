// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/swarm_race.hpp"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "support/program.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {

using testing::HasSubstr;

TEST(SwarmRace, TheImprovedFormBeatsThePrintedOneWhereSearchersAreFew) {
  std::map<std::string, SwarmRaceCell> of_twenty;
  for (const auto& cell : raceSwarms(8)) {
    EXPECT_EQ(cell.runs.size(), 8u);
    EXPECT_LE(cell.iterations(), 500.0);
    if (cell.searchers == 20) of_twenty[cell.function + "/" + cell.move] = cell;
  }
  EXPECT_EQ(of_twenty.size(), 42u);
  for (const std::string function : {"Rastrigin", "Ackley", "Eggcrate"}) {
    EXPECT_GE(of_twenty[function + "/lbba improved"].found(), 7) << function;
    EXPECT_LT(of_twenty[function + "/lbba improved"].iterations(),
              of_twenty[function + "/lbba as printed"].iterations())
        << function;
  }
  // Leaps along the axes do not help where a function is turned.
  EXPECT_GT(of_twenty["Rastrigin/lbba improved"].found(),
            of_twenty["Rastrigin turned/lbba improved"].found());
}

TEST(SwarmRace, IsPrintedAndPlotted) {
  std::vector<SwarmRaceCell> cells;
  for (const int searchers : {20, 50, 100, 300, 600, 1200}) {
    cells.push_back(
        {"Ackley", "pso", searchers, {{40, true}, {13, true}, {10, true}, {500, false}}});
  }
  EXPECT_THAT(toTable(cells), HasSubstr("\n| Ackley, pso | 141 (75) | 141 (75) |"));
  const TempFolder folder;
  const std::string file = folder.file("race.png");
  savePlot(cells, file);
  EXPECT_EQ(cv::imread(file).rows, 440);
  EXPECT_THROW(savePlot(cells, folder.file("race.nosuch")), std::runtime_error);

  saveJson(cells, folder.file("race.json"));
  const auto json = nlohmann::json::parse(readWhole(folder.file("race.json")));
  EXPECT_EQ(json.size(), 6u);
  EXPECT_EQ(json[1]["searchers"], 50);
  EXPECT_EQ(json[1]["runs"][3]["iterations"], 500);
  EXPECT_EQ(json[1]["runs"][3]["is_reached"], false);
}

}  // namespace adaptive_localization
