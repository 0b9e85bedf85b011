// SPDX-License-Identifier: BSD-3-Clause
// The program energy_grid, by what it says and draws.
#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "adaptive_localization/map/map_io.hpp"
#include "eval/energy_command.hpp"
#include "support/program.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing::ThrowsMessage;

class EnergyGridProgram : public testing::Test {
 protected:
  ProgramResult run(std::vector<std::string> arguments, const std::string& map = "") const {
    arguments.insert(arguments.begin(), {"--map", map.empty() ? save(*asymmetricWorld()) : map});
    return runProgram(ENERGY_GRID, arguments);
  }
  std::string save(const OccupancyGrid& map) const {
    saveMap(map, folder_.file("map"));
    return folder_.file("map.yaml");
  }
  std::string file(const std::string& name) const { return folder_.file(name); }

 private:
  TempFolder folder_;
};

int number(const std::string& text, const std::string& after) {
  const auto at = text.find(after);
  return at == std::string::npos ? -1 : std::stoi(text.substr(at + after.size()));
}

/// Pixels that are neither black, white nor grey.
int colouredPixels(const cv::Mat& image) {
  int coloured = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const auto& pixel = image.at<cv::Vec3b>(row, column);
      coloured += pixel[0] != pixel[1] || pixel[1] != pixel[2];
    }
  }
  return coloured;
}

TEST_F(EnergyGridProgram, TellsWhatIsInTheGrid) {
  const auto map = asymmetricWorld();
  const auto result = run({"--orientations", "12", "--beams", "20"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  const auto cells = static_cast<int>(map->countFree());
  EXPECT_EQ(number(result.output, "grid: "), cells);
  EXPECT_EQ(number(result.output, " headings = "), 12 * cells);
  EXPECT_THAT(result.output, ContainsRegex("built in [0-9.]+ s\n"));

  // all poses are in the histogram
  long counted = 0;
  for (auto at = result.output.find(" to "); at != std::string::npos;
       at = result.output.find(" to ", at + 1)) {
    counted += std::stol(result.output.substr(at + 8));
  }
  EXPECT_EQ(counted, 12L * cells);
}

TEST_F(EnergyGridProgram, TakesTheDistanceBetweenPositions) {
  const auto cells = static_cast<int>(asymmetricWorld()->countFree());
  EXPECT_EQ(number(run({"--pitch", "0.1"}).output, "grid: "), cells / 4) << "two cells";
  EXPECT_NEAR(number(run({"--pitch", "0.25"}).output, "grid: "), cells / 25, cells / 250);
}

TEST_F(EnergyGridProgram, KnowsThatALaserAllRoundNeedsOneHeading) {
  EXPECT_THAT(run({"--view", "360"}).output, HasSubstr(" x 1 headings = "));
}

TEST_F(EnergyGridProgram, FindsWhereAScanWasTaken) {
  const auto result = run({"--query", "1.52,1.51,0.7"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output,
              AllOf(ContainsRegex("scan: energy 0\\.[0-9]+; region: [1-9]"),
                    HasSubstr("search: 1 place in"),
                    ContainsRegex("x 1\\.(4[89]|5[0-5])[0-9] m, y 1\\.(4[89]|5[0-4])")));
}

TEST_F(EnergyGridProgram, FindsBothPlacesThatLookAlike) {
  const auto result = run({"--query", "1.0,1.1,0.4"}, save(*symmetricWorld()));
  EXPECT_THAT(result.output, HasSubstr("search: 2 places in"));
}

TEST_F(EnergyGridProgram, DrawsEnergiesAndRegion) {
  for (const std::vector<std::string>& query :
       {std::vector<std::string>{}, {"--query", "1.5,1.5,0.7"}}) {
    std::vector<std::string> arguments{"--json", file("grid.json")};
    arguments.insert(arguments.end(), query.begin(), query.end());
    const auto result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const auto drawn = runProgram(SOURCE_DIR "/scripts/draw", {file("grid.json")});
    ASSERT_EQ(drawn.exit_code, 0) << drawn.errors;
    const cv::Mat image = cv::imread(file("grid.png"));
    ASSERT_EQ(image.cols, 1100);
    const double share = colouredPixels(image) / static_cast<double>(image.total());
    EXPECT_GT(share, query.empty() ? 0.3 : 0.05);
    EXPECT_LT(share, query.empty() ? 0.9 : 0.3);
  }
}

TEST_F(EnergyGridProgram, NamesWhatIsWrong) {
  const auto expectError = [&](const ProgramResult& result, const std::string& why) {
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, AllOf(StartsWith("energy_grid: "), HasSubstr(why)));
  };
  expectError(run({}, "/does/not/exist.yaml"), "'/does/not/exist.yaml'");
  expectError(run({"--beams", "0"}),
              "'energy_beams': got '0', expected a whole number in [1, 180]");
  expectError(run({"--max-range", "far"}), "'energy_max_range': got 'far', expected a number");
  expectError(run({"--query", "-5,0,0"}), "--query: that is not on free ground of ");
  expectError(run({"--json", "/does/not/exist.json"}), "'/does/not/exist.json'");
  expectError(run({}, save(*toyWorld({"##", "??"}, 0.05))), "no free cell");
}

TEST(EnergyCommand, RejectsWhatItDoesNotKnow) {
  const auto expectRejected = [](std::vector<std::string> arguments, const std::string& why) {
    arguments.insert(arguments.begin(), {"--map", "m.yaml"});
    EXPECT_THAT([&] { parseEnergyCommand(arguments); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
  };
  expectRejected({"--speed", "3"}, "unknown argument '--speed'");
  expectRejected({"--beam", "3"}, "'--beam'; did you mean '--beams'?");
  expectRejected({"--beams"}, "--beams needs a value");
  for (const char* view : {"", "0", "361", "nan", "90deg"}) {
    expectRejected({"--view", view}, "--view: got '" + std::string(view) + "', expected 1 to 360");
  }
  for (const char* query : {"here", "1,2", "1,2,3,4", "nan,0,0", "1;2;3"}) {
    expectRejected({"--query", query}, "--query: got '" + std::string(query) + "', expected X,Y");
  }
  EXPECT_THAT([] { parseEnergyCommand({}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("--map is missing")));
  EXPECT_THAT(runProgram(ENERGY_GRID, {"--view", "wide"}).errors, HasSubstr("usage: energy_grid"));
}

TEST(EnergyCommand, HelpNeedsNothingElse) {
  const auto result = runProgram(ENERGY_GRID, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, AllOf(StartsWith("usage:"), HasSubstr("--query X,Y,YAW")));
  EXPECT_THAT(result.output, Not(HasSubstr("missing")));
}

}  // namespace
}  // namespace adaptive_localization
