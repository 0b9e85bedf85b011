// SPDX-License-Identifier: BSD-3-Clause
// Recorded drives of real robots, replayed; skipped where the recordings are absent.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <tuple>

#include "adaptive_localization/eval/log_reader.hpp"
#include "support/program.hpp"

namespace adaptive_localization {
namespace {

std::string dataFolder() {
  const char* named = std::getenv("ADAPTIVE_LOCALIZATION_DATA");
  return named ? named : SOURCE_DIR "/../shared/data";
}

struct Drive {
  const char* folder;
  const char* log;
  const char* map;
  double begin, end;  // stamps
  const char* reference_argument;
  const char* reference;  // a file name has a dot
  double most_error;      // m, root mean square
};

void PrintTo(const Drive& drive, std::ostream* output) {
  *output << drive.log;
}

// The errors that filters must stay below; the references are good to 2 to 5 cm.
const Drive kDrives[] = {
    {"intel", "intel.bag", "map_w1.yaml", 976053311.182277, 976053560.473733, "--truth-topic",
     "/reference_pose", 0.03},
    {"fr079", "fr079.bag", "map_w1.yaml", 1211.520329, 1349.370669, "--truth-topic",
     "/reference_pose", 0.03},
    {"aces", "aces.bag", "map_w2.yaml", 2141.730099, 2223.1801, "--truth-topic", "/reference_pose",
     0.045},
    {"p3dx_birmingham", "trace0_clean.bag", "newlowerground.yaml", 0.0, 2e9, "--truth",
     "trace0_reference.tum", 0.08},
};

class RecordedDrive : public testing::TestWithParam<std::tuple<Drive, const char*>> {};

TEST_P(RecordedDrive, IsFollowed) {
  const auto& [drive, filter] = GetParam();
  const std::string folder = dataFolder() + "/" + drive.folder + "/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no recorded data in " << folder;
  const bool is_file = std::string(drive.reference).find('.') != std::string::npos;
  const TempFolder results;
  const ProgramResult result =
      runProgram(REPLAY, {"--map", folder + drive.map, "--log", folder + drive.log, "--begin",
                          std::to_string(drive.begin), "--end", std::to_string(drive.end),
                          drive.reference_argument, (is_file ? folder : "") + drive.reference,
                          "--filter", filter, "--seed", "1", "--json", results.file("o.json")});
  if (result.errors.find("built without rosbag") != std::string::npos) {
    GTEST_SKIP() << result.errors;
  }
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = nlohmann::json::parse(readWhole(results.file("o.json")));
  EXPECT_GT(json.at("scans"), 500);
  EXPECT_FALSE(json.at("converged_at_s").is_null()) << result.output;
  EXPECT_LT(json.at("lost_share"), 0.05) << result.output;
  EXPECT_LT(json.at("ate_rmse_m"), drive.most_error) << result.output;
}

INSTANTIATE_TEST_SUITE_P(RecordedData, RecordedDrive,
                         testing::Combine(testing::ValuesIn(kDrives),
                                          testing::Values("kld", "ekf_icp")),
                         [](const auto& about) {
                           return std::string(std::get<0>(about.param).folder) + "_" +
                                  std::get<1>(about.param);
                         });

Log readWholeLog(const std::string& file) {
  LogRequest request;
  request.file = file;
  return readLog(request);
}

TEST(RecordedData, BagAndCarmenLogTellTheSame) {
  const std::string folder = dataFolder() + "/intel/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no recorded data in " << folder;
  const Log carmen = readWholeLog(folder + "intel.clf.bz2");
  Log bag;
  try {
    bag = readWholeLog(folder + "intel.bag");
  } catch (const std::invalid_argument& error) {
    const std::string why = error.what();
    ASSERT_NE(why.find("built without rosbag"), std::string::npos) << why;
    GTEST_SKIP() << why;
  }
  ASSERT_EQ(carmen.scans.size(), 13631U);
  ASSERT_EQ(bag.scans.size(), carmen.scans.size());
  for (std::size_t i = 0; i < bag.scans.size(); ++i) {
    const Pose2 difference = between(carmen.scans[i].T_odom_base, bag.scans[i].T_odom_base);
    ASSERT_NEAR(std::hypot(difference.x, difference.y), 0.0, 0.001) << "scan " << i;
    ASSERT_NEAR(difference.theta, 0.0, 0.001) << "scan " << i;
    ASSERT_EQ(carmen.scans[i].scan.ranges, bag.scans[i].scan.ranges) << "scan " << i;
    ASSERT_NEAR(carmen.scans[i].scan.stamp, bag.scans[i].scan.stamp, 0.001) << "scan " << i;
  }
}

}  // namespace
}  // namespace adaptive_localization
