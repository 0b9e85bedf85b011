// SPDX-License-Identifier: BSD-3-Clause
// The executable as its user meets it.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

struct Cell {
  double iterations{0.0};  // mean
  int found{0};
};

TEST(SwarmFunctions, TheImprovedFormBeatsThePrintedOneWhereSearchersAreFew) {
  const TempFolder folder;
  const std::string file = folder.file("race.json");
  const ProgramResult result = runProgram(SWARM_FUNCTIONS, {"--seeds", "8", "--json", file});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::map<std::string, Cell> of_twenty;
  for (const auto& json : nlohmann::json::parse(readWhole(file))) {
    ASSERT_EQ(json.at("runs").size(), 8U);
    if (json.at("searchers") != 20) continue;
    Cell& cell = of_twenty[json.at("function").get<std::string>() + "/" +
                           json.at("move").get<std::string>()];
    for (const auto& run : json.at("runs")) {
      EXPECT_LE(run.at("iterations"), 500);
      cell.iterations += run.at("iterations").get<int>() / 8.0;
      cell.found += run.at("is_reached").get<bool>();
    }
  }
  EXPECT_EQ(of_twenty.size(), 42U);
  for (const std::string function : {"Rastrigin", "Ackley", "Eggcrate"}) {
    EXPECT_GE(of_twenty[function + "/lbba improved"].found, 7) << function;
    EXPECT_LT(of_twenty[function + "/lbba improved"].iterations,
              of_twenty[function + "/lbba as printed"].iterations)
        << function;
  }
  // Leaps along the axes do not help where a function is turned.
  EXPECT_GT(of_twenty["Rastrigin/lbba improved"].found,
            of_twenty["Rastrigin turned/lbba improved"].found);
}

}  // namespace
}  // namespace adaptive_localization
