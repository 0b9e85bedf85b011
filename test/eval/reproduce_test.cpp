// SPDX-License-Identifier: BSD-3-Clause
// scripts/reproduce, as somebody uses it who wants to see a table of the literature again.
#include <gmock/gmock.h>

#include <cstdlib>
#include <regex>

#include "support/program.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;

ProgramResult reproduce(const std::vector<std::string>& arguments) {
  setenv("EXPERIMENTS", EXPERIMENTS, 1);
  setenv("SWARM_FIXES", SWARM_FIXES, 1);
  setenv("SWARM_FUNCTIONS", SWARM_FUNCTIONS, 1);
  setenv("SONAR_MAP", SONAR_MAP, 1);
  return runProgram(SOURCE_DIR "/scripts/reproduce", arguments);
}

TEST(Reproduce, TellsWhatIsPrintedAndWhatBothPresetsDo) {
  const TempFolder folder;
  const std::vector<std::string> arguments{"E17", "--seeds", "2", "--out", folder.file("results")};
  const ProgramResult first = reproduce(arguments);
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  const std::regex row(
      R"(\| ekf_icp seed, share \| 1 \| ([0-9.]+) \([^|]*n = 2\) )"
      R"(\| 1 \([^|]*n = 2\) \| (as printed|better|worse); (?:as printed|better) \|)");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(first.output, found, row)) << first.output;
  EXPECT_LE(std::stod(found[1]), 1.0);

  const std::string results = readWhole(folder.file("results/mbot.jsonl"));
  EXPECT_EQ(reproduce(arguments).output, first.output);
  EXPECT_EQ(readWhole(folder.file("results/mbot.jsonl")), results);  // nothing again
}

TEST(Reproduce, ComparesFixesOfSwarmsAsWell) {
  const TempFolder folder;
  const ProgramResult result =
      reproduce({"E9", "--seeds", "2", "--first-seed", "5", "--out", folder.file("results")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const std::regex row(
      R"(\| lbba, seed, mm \| 2\.3098 \| [^|]*n = [12][^|]*\| [0-9.]+ \([^|]*n = 2\) \|)");
  EXPECT_TRUE(std::regex_search(result.output, row)) << result.output;
  const std::regex exact(
      R"(\| lbba, seed, exact ranges, mm \| 2\.3098 \| [^|]*\| ([0-9.]+) \([^|]*n = 2\) \|)");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(result.output, found, exact)) << result.output;
  EXPECT_LT(std::stod(found[1]), 2.3);  // mm, below print
}

TEST(Reproduce, ComparesThePresetsWherePrintHasAPicture) {
  const TempFolder folder;
  const ProgramResult result = reproduce({"E7", "--seeds", "4", "--out", folder.file("results")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const std::regex row(
      R"(\| lbba, Ackley, 20: iterations \|  \| [^|]*n = 4\) \| [^|]*n = 4\) \| better \|)");
  EXPECT_TRUE(std::regex_search(result.output, row)) << result.output;
}

TEST(Reproduce, ComparesModelsSideBySide) {
  const TempFolder folder;
  const ProgramResult result = reproduce({"E19", "--seeds", "1", "--out", folder.file("results")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("| what | moravec-elfes | elfes | konolige |"));
  const std::regex row(R"(\| all readings: F-score (\| 0\.[0-9]+ \([^|]*n = 1\) ){3}\|)");
  EXPECT_TRUE(std::regex_search(result.output, row)) << result.output;
}

TEST(Reproduce, NamesWhatItKnows) {
  const ProgramResult unknown = reproduce({"E99"});
  EXPECT_NE(unknown.exit_code, 0);
  EXPECT_THAT(unknown.errors,
              AllOf(HasSubstr("'E99'"), HasSubstr("E1 E2 E3 E4 E5 E6 E7 E8 E9 E10 E11 E12 E13 E14 "
                                                  "E15 E16 E17 E18 E19 E20")));
  const ProgramResult list = reproduce({"--list"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.output, AllOf(HasSubstr("E4 "), HasSubstr("(Li 2016, T5)")));
}

/// Every table has its place on the page.
TEST(Reproduce, HasAPageForItsTables) {
  const std::string page = readWhole(SOURCE_DIR "/doc/sources.md");
  const std::string list = reproduce({"--list"}).output;
  const std::regex name("(^|\n)(E[0-9]+)");
  int count = 0;
  for (std::sregex_iterator at(list.begin(), list.end(), name), end; at != end; ++at, ++count) {
    EXPECT_THAT(page, HasSubstr("<!-- " + (*at)[2].str() + " -->\n"));
    EXPECT_THAT(page, HasSubstr("<!-- end of " + (*at)[2].str() + " -->\n"));
  }
  EXPECT_EQ(count, 20);
}

}  // namespace
}  // namespace adaptive_localization
