// SPDX-License-Identifier: BSD-3-Clause
// Experiment E20: what a Kalman filter believes while it observes nothing, and beside a wall.
#include "eval/line_drive.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "support/program.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

constexpr double kAside = 0.5 * kPi;  // rad, from ahead

/// Along a single wall on the right, which comes into view after 8 m.
const LineDrive& alongTheWall() {
  static const LineDrive drive = [] {
    LineDrivePlan plan;
    plan.world = SOURCE_DIR "/maps/wall/world.yaml";
    plan.duration = 40.0;
    plan.robot.set("laser_max_range", OptionValue(4.0));
    plan.robot.set("laser_bias", OptionValue(0.015));
    plan.robot.set("seed", OptionValue(2));
    plan.options.set("odom_alpha2", OptionValue(0.05));
    return driveByLines(plan);
  }();
  return drive;
}

double across(const LineDriveStep& step, const Gaussian2& belief) {
  return deviationAlong(belief, step.T_map_base.theta + kAside);
}

double along(const LineDriveStep& step, const Gaussian2& belief) {
  return deviationAlong(belief, step.T_map_base.theta);
}

/// In a direction of the map's.
double errorAlong(const LineDriveStep& step, const Gaussian2& belief, double angle) {
  return std::abs((belief.mean.x - step.T_map_base.x) * std::cos(angle) +
                  (belief.mean.y - step.T_map_base.y) * std::sin(angle));
}

/// The steps before the wall corrects anything.
std::vector<LineDriveStep> blindSteps() {
  std::vector<LineDriveStep> steps;
  for (const auto& step : alongTheWall().steps) {
    if (step.lines.covariance != step.odometry.covariance) break;
    steps.push_back(step);
  }
  return steps;
}

TEST(LineDrive, TheEllipseGrowsFromStepToStepWithoutObservation) {
  double area = 0.0;
  for (const auto& step : alongTheWall().steps) {
    ASSERT_GT(ellipseArea(step.odometry), area) << step.stamp << " s";
    area = ellipseArea(step.odometry);
  }
  EXPECT_GT(area, 20.0 * ellipseArea(alongTheWall().steps.front().odometry));
}

TEST(LineDrive, NothingIsCorrectedBeforeTheWallIsInView) {
  const auto blind = blindSteps();
  ASSERT_GT(blind.size(), 100U);
  EXPECT_GT(blind.back().driven, 6.0);
  EXPECT_LT(blind.back().driven, 11.0);
  for (const auto& step : blind) EXPECT_EQ(distance(step.lines.mean, step.odometry.mean), 0.0);
}

TEST(LineDrive, AWallOnTheRightCorrectsAcrossIt) {
  const LineDriveStep& last = alongTheWall().steps.back();
  EXPECT_LT(across(last, last.lines), across(last, last.odometry) / 20.0);
  EXPECT_LT(ellipseArea(last.lines), ellipseArea(last.odometry) / 10.0);
  EXPECT_LT(errorAlong(last, last.lines, kAside), 0.05);
  EXPECT_GT(errorAlong(last, last.odometry, kAside), 1.0);
}

/// The wall runs along x: what is left of the variance in x is that given y and heading, and it
/// grows from then on.
TEST(LineDrive, AWallOnTheRightTellsNothingAlongIt) {
  const std::size_t blind = blindSteps().size();
  const auto& steps = alongTheWall().steps;
  ASSERT_GT(steps.size(), blind + 100U);
  const Eigen::Matrix3d& predicted = steps[blind].odometry.covariance;
  const Eigen::RowVector2d shared = predicted.topRightCorner<1, 2>();
  const Eigen::Matrix2d known = predicted.bottomRightCorner<2, 2>();
  const double left = predicted(0, 0) - shared.dot(known.inverse() * shared.transpose());
  EXPECT_GE(steps[blind].lines.covariance(0, 0), left);
  EXPECT_LT(steps[blind].lines.covariance(0, 0), 1.05 * left);
  for (std::size_t i = blind + 1; i < steps.size(); ++i) {
    ASSERT_GT(steps[i].lines.covariance(0, 0), steps[i - 1].lines.covariance(0, 0))
        << steps[i].stamp << " s";
  }
}

/// B, where odometry has the robot, is moved to C.
TEST(LineDrive, TheFirstLineMovesThePoseTowardsTheTruth) {
  const std::size_t blind = blindSteps().size();
  const LineDriveStep& before = alongTheWall().steps.at(blind - 1);
  const LineDriveStep& after = alongTheWall().steps.at(blind);
  EXPECT_GT(errorAlong(before, before.lines, kAside), 0.5);
  EXPECT_LT(errorAlong(after, after.lines, kAside), 0.1);
  EXPECT_LT(across(after, after.lines), across(before, before.lines) / 10.0);
}

TEST(LineDrive, TheTruthIsWithinTheEllipseOfTheCorrectedOne) {
  for (const auto& step : alongTheWall().steps) {
    EXPECT_LT(errorAlong(step, step.lines, 0.0), 3.03 * along(step, step.lines)) << step.stamp;
    EXPECT_LT(errorAlong(step, step.lines, kAside), 3.03 * across(step, step.lines) + 0.05)
        << step.stamp;
  }
}

TEST(LineDrive, TheLastScanShowsTheWallThatItWasMatchedWith) {
  const LineDrive& drive = alongTheWall();
  ASSERT_EQ(drive.matched.size(), 1U);
  EXPECT_NEAR(drive.matched[0].a.y(), 6.0, 1e-9);
  EXPECT_NEAR(drive.matched[0].b.y(), 6.0, 1e-9);
  EXPECT_TRUE(std::any_of(drive.seen.begin(), drive.seen.end(),
                          [](const SeenLine& line) { return line.is_matched; }));
}

TEST(LineDrive, AnEllipseHasTheSizeOfItsAxes) {
  Gaussian2 belief;
  belief.covariance.diagonal() << 0.04, 0.01, 0.0;
  const double scale = 3.034854;  // sqrt(-2 ln 0.01)
  EXPECT_NEAR(ellipseArea(belief), kPi * 0.02 * scale * scale, 1e-6);
  EXPECT_NEAR(deviationAlong(belief, 0.0), 0.2, 1e-9);
  EXPECT_NEAR(deviationAlong(belief, kAside), 0.1, 1e-9);
}

class LineDriveProgram : public testing::Test {
 protected:
  static void expectRejected(const std::vector<std::string>& arguments, const std::string& why) {
    const ProgramResult result = runProgram(LINE_DRIVE, arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, HasSubstr(why));
  }

  const std::string world_{SOURCE_DIR "/maps/maze/world.yaml"};
};

TEST_F(LineDriveProgram, PrintsATableAndDraws) {
  const TempFolder folder;
  const ProgramResult result =
      runProgram(LINE_DRIVE, {world_, "--seconds", "5", "--robot", "people=2", "seed=3", "--set",
                              "line_overlap=0.6", "--json", folder.file("drive.json")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 13);
  const ProgramResult drawn = runProgram(SOURCE_DIR "/scripts/draw", {folder.file("drive.json")});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.errors;
  EXPECT_EQ(readWhole(folder.file("drive.png")).compare(1, 3, "PNG"), 0);
}

TEST_F(LineDriveProgram, NamesWhatItCannotTake) {
  expectRejected({}, "WORLD.yaml is missing");
  expectRejected({"nosuch.yaml"}, "nosuch.yaml");
  expectRejected({world_, "other"}, "'other' is one too many");
  expectRejected({world_, "--seconds", "0"}, "--seconds");
  expectRejected({world_, "--set", "line_overlap"}, "expected KEY=VALUE");
  expectRejected({world_, "--set", "line_overlp=1"}, "did you mean 'line_overlap'");
  expectRejected({world_, "--set", "line_gate=1"},
                 "'line_gate': got 1, but this option was removed");
  expectRejected({world_, "--robot", "peple=1"}, "did you mean 'people'");
  expectRejected({world_, "--robot", "lasers=0"}, "'lasers'");
  expectRejected({world_, "--seconds", "1", "--json", "/nosuch/x.json"}, "/nosuch/x.json");
}

}  // namespace
}  // namespace adaptive_localization
