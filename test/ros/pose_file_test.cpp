// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pose_file.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

class PoseFileTest : public testing::Test {
 protected:
  void write(const std::string& text) { std::ofstream(path_) << text; }
  std::string complaint() {
    try {
      readPoseFile(path_);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no complaint";
  }

  TempFolder folder_;
  std::string path_ = folder_.file("pose.yaml");
};

TEST_F(PoseFileTest, ReadsWhatWasWrittenLast) {
  EXPECT_FALSE(readPoseFile(path_));
  Gaussian2 pose;
  pose.mean = {9.0, 9.0, 9.0};
  writePoseFile(path_, pose);
  pose.mean = {-1234.5678, 0.25, -3.0};
  pose.covariance.diagonal() << 0.01, 1e-7, 0.003;
  writePoseFile(path_, pose);
  const auto read = readPoseFile(path_);
  ASSERT_TRUE(read);
  EXPECT_NEAR(read->mean.x, -1234.5678, 1e-5);
  EXPECT_NEAR(read->mean.theta, -3.0, 1e-9);
  EXPECT_TRUE(read->covariance.isApprox(pose.covariance, 1e-6));
  EXPECT_FALSE(std::ifstream(path_ + ".part"));
}

TEST_F(PoseFileTest, SaysWhatIsWrongWithABrokenFile) {
  write("");
  EXPECT_THAT(complaint(), HasSubstr("expected six finite numbers"));
  write("initial_pose_x: 1\ninitial_pose_y: 2\n");
  EXPECT_THAT(complaint(), HasSubstr("expected six finite numbers"));
  write("initial_pose_x: [1");
  EXPECT_THAT(complaint(), HasSubstr(path_));
  write("initial_pose_x: here");
  EXPECT_THAT(complaint(), HasSubstr("'initial_pose_x': got 'here'"));
  write("initial_cov_xx: -1");
  EXPECT_THAT(complaint(), HasSubstr("'initial_cov_xx': got '-1'"));
  write(std::string("\0\0\0\xff\xfe garbage", 14));
  EXPECT_THAT(complaint(), HasSubstr(path_));
}

TEST_F(PoseFileTest, SaysWhyItCannotBeWritten) {
  try {
    writePoseFile(folder_.file("no/such/folder/pose.yaml"), {});
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

}  // namespace
}  // namespace adaptive_localization
