// SPDX-License-Identifier: BSD-3-Clause
#include "core/whole_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <thread>

#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string contentsOf(const std::string& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

class WholeFile : public testing::Test {
 protected:
  TempFolder folder_;
  std::string file_{folder_.file("x")};
};

TEST_F(WholeFile, ReplacesTheOldOne) {
  const std::string all("a\0b\n", 4);
  writeWholeFile(file_, "a longer text");
  writeWholeFile(file_, all);
  EXPECT_EQ(contentsOf(file_), all);
  EXPECT_FALSE(fs::exists(file_ + ".part"));
}

/// No file can be made in its folder under the other name.
TEST_F(WholeFile, LeavesTheOldOneIfTheNewCannotBeWritten) {
  folder_.write("x", "old");
  fs::create_directory(file_ + ".part");
  EXPECT_THAT([&] { writeWholeFile(file_, "new"); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr(file_), HasSubstr("cannot be written: Is a directory"))));
  EXPECT_EQ(contentsOf(file_), "old");
}

/// As two nodes with one pose_file do.
TEST_F(WholeFile, IsOneOfTwoThatAreWrittenAtTheSameTime) {
  const std::string longer(100000, 'a'), shorter(50000, 'b');
  const auto writeOften = [&](const std::string& contents) {
    for (int i = 0; i < 100; ++i) {
      writeWholeFile(file_, contents);
      const std::string found = contentsOf(file_);
      ASSERT_TRUE(found == longer || found == shorter) << found.size();
    }
  };
  std::thread other([&] { writeOften(shorter); });
  writeOften(longer);
  other.join();
  EXPECT_FALSE(fs::exists(file_ + ".part"));
}

TEST_F(WholeFile, WritesWhereALinkLeads) {
  folder_.write("target", "old");
  fs::create_symlink(folder_.file("target"), file_);
  writeWholeFile(file_, "new");
  EXPECT_TRUE(fs::is_symlink(file_));
  EXPECT_EQ(contentsOf(folder_.file("target")), "new");
}

/// A pipe is not replaced by a file; nor is /dev/full, which has no room for anything.
TEST_F(WholeFile, WritesToWhatIsNoFile) {
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  FILE* reader = popen(("cat " + file_).c_str(), "r");
  ASSERT_NE(reader, nullptr);
  writeWholeFile(file_, "through");
  char text[20] = {};
  EXPECT_NE(fgets(text, sizeof text, reader), nullptr);
  EXPECT_EQ(pclose(reader), 0);
  EXPECT_EQ(std::string(text), "through");
  EXPECT_TRUE(fs::is_fifo(file_));
  EXPECT_THAT([] { writeWholeFile("/dev/full", "new"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("No space left on device")));
}

}  // namespace
}  // namespace adaptive_localization
