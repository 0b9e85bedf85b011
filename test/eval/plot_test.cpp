// SPDX-License-Identifier: BSD-3-Clause
#include "eval/plot.hpp"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

OccupancyGrid emptyMap() {
  const Lattice lattice(400, 300, 0.05, {-2.0, -3.0, 0.0});
  return {lattice, std::vector<std::int8_t>(lattice.size(), OccupancyGrid::kFree)};
}

RunRecord straightDrive() {
  RunRecord run;
  for (int i = 0; i <= 10; ++i) {
    RunStep step;
    step.stamp = i;
    step.T_map_base = {0.5 * i, 0.0, 0.0};
    step.T_map_base_reference = Pose2{0.5 * i, 1.0, 0.0};
    run.steps.push_back(step);
  }
  return run;
}

int count(const cv::Mat& image, bool (*isWanted)(const cv::Vec3b&)) {
  int pixels = 0;
  for (const auto& pixel : cv::Mat_<cv::Vec3b>(image)) pixels += isWanted(pixel) ? 1 : 0;
  return pixels;
}

bool isRed(const cv::Vec3b& p) {
  return p[2] > 180 && p[0] < 80 && p[1] < 80;
}
bool isBlue(const cv::Vec3b& p) {
  return p[0] > 180 && p[2] < 120;
}

TEST(Plot, ShowsReferenceAndEstimate) {
  const TempFolder folder;
  const RunRecord run = straightDrive();
  savePlot(emptyMap(), run, measure(run), folder.file("a.png"));
  const cv::Mat image = cv::imread(folder.file("a.png"));
  ASSERT_FALSE(image.empty());
  EXPECT_GT(image.cols, 1000);
  EXPECT_GT(count(image, isRed), 800);
  EXPECT_GT(count(image, isBlue), 1500);
}

TEST(Plot, LeavesOutAReferenceThatIsNotThere) {
  const TempFolder folder;
  RunRecord run = straightDrive();
  for (auto& step : run.steps) step.T_map_base_reference.reset();
  savePlot(emptyMap(), run, measure(run), folder.file("a.png"));
  EXPECT_EQ(count(cv::imread(folder.file("a.png")), isBlue), 0);
}

TEST(Plot, SurvivesPosesFarOff) {
  const TempFolder folder;
  RunRecord run = straightDrive();
  run.steps[3].T_map_base.x = 1e300;
  run.steps[4].T_map_base.x = std::nan("");
  savePlot(emptyMap(), run, measure(run), folder.file("a.png"));
  EXPECT_GT(count(cv::imread(folder.file("a.png")), isRed), 100);
}

TEST(Plot, SaysWhichFileCannotBeWritten) {
  const RunRecord run = straightDrive();
  for (const char* file : {"/does/not/exist.png", "/tmp/plot.without_format"}) {
    EXPECT_THAT([&] { savePlot(emptyMap(), run, measure(run), file); },
                testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(file)));
  }
}

}  // namespace
}  // namespace adaptive_localization
