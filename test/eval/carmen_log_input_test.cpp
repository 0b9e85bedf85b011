// SPDX-License-Identifier: BSD-3-Clause
// Packed files, broken lines and CARMEN logs with something wrong.
#include <gmock/gmock.h>

#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cmath>

#include "adaptive_localization/core/rng.hpp"
#include "eval/log_reader.hpp"
#include "eval/small_carmen_log.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

LogRequest requestFor(const std::string& file) {
  LogRequest request;
  request.file = file;
  return request;
}

TEST(CarmenLog, NamesBrokenLinesByNumberAndGoesOn) {
  const Log log = read(
      "PARAM robot_frontlaser_offset 0 host 0\n"
      "FLASER 3 1.0 2.0\n"
      "FLASER 3 1.0 2.x 3.0 0 0 0 0 0 0 10.1 host 0.1\n"
      "FLASER -3 1.0\n"
      "FLASER 2 1.0 2.0 0 0 0 0 0 0 10.2 host 0.2\n"
      "ODOM 1 2\n"
      "FLASER 0 0 0 0 0 0 0 10.1 host 0.1\n"
      "FLASER 999999999999 1.0\n"
      "PARAM robot_frontlaser_offset here host 0\n");
  EXPECT_EQ(log.scans.size(), 1U);
  EXPECT_EQ(log.skipped, 7);
  EXPECT_THAT(log.warnings,
              ElementsAre(HasSubstr("line 2: ends before 'range'"),
                          HasSubstr("line 3: range: got '2.x', expected a number"),
                          HasSubstr("line 4"), HasSubstr("line 6"), HasSubstr("line 7"),
                          HasSubstr("line 8"), HasSubstr("line 9"), HasSubstr("7")));
}

TEST(CarmenLog, DoesNotFloodItsReaderWithWarnings) {
  std::string text = kSmallLog;
  for (int i = 0; i < 1000; ++i) text += "FLASER 3 1.0 2.0\n";
  const Log log = read(text);
  EXPECT_EQ(log.skipped, 1000);
  EXPECT_LT(log.warnings.size(), 30U);
  EXPECT_THAT(log.warnings, Contains(HasSubstr("1000")));
}

template <class Packer>
std::string packed(const std::string& text) {
  std::ostringstream result;
  {
    boost::iostreams::filtering_ostream output;
    output.push(Packer());
    output.push(result);
    output << text;
  }
  return result.str();
}

TEST(CarmenLog, ReadsPlainAndPackedFilesAlike) {
  const TempFolder folder;
  const std::string plain = folder.write("a.clf", kSmallLog);
  const std::string gzip =
      folder.write("a.clf.gz", packed<boost::iostreams::gzip_compressor>(kSmallLog));
  const std::string bzip2 =
      folder.write("a.clf.bz2", packed<boost::iostreams::bzip2_compressor>(kSmallLog));
  for (const auto& file : {plain, gzip, bzip2}) {
    const Log log = readLog(requestFor(file));
    EXPECT_EQ(log.scans.size(), 2U) << file;
    EXPECT_DOUBLE_EQ(log.scans.back().T_odom_base.theta, 0.5) << file;
  }
}

TEST(CarmenLog, SaysWhichFileCannotBeUnpacked) {
  const TempFolder folder;
  const std::string whole = packed<boost::iostreams::bzip2_compressor>(kSmallLog);
  for (const auto& file :
       {folder.write("plain.gz", kSmallLog), folder.write("plain.bz2", kSmallLog),
        folder.write("half.bz2", whole.substr(0, whole.size() / 2))}) {
    EXPECT_THAT([&] { readLog(requestFor(file)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("'" + file + "'")));
  }
}

TEST(CarmenLog, WantsScans) {
  const TempFolder folder;
  for (const auto& file : {folder.write("empty.clf", ""), folder.write("text.clf", "Hello\nyou\n"),
                           folder.file("missing.clf"), folder.file("")}) {
    EXPECT_THAT([&] { readLog(requestFor(file)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("log '" + file + "'")));
  }
}

TEST(CarmenLog, HasNoTopics) {
  const TempFolder folder;
  LogRequest request = requestFor(folder.write("a.clf", kSmallLog));
  request.truth_topic = "/truth";
  EXPECT_THAT([&] { readLog(request); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("a CARMEN log has no topics")));
}

TEST(CarmenLog, SurvivesRandomMutations) {
  Rng rng(5);
  const std::string original = std::string(kSmallLog) +
                               "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 2 7 8 0.1 0 0 4 5 6 "
                               "0 0 0.3 0.3 1e10 99.5 host 9.5\n";
  const std::string alphabet = "0123456789.-e \n#FLASERnaif\t\xff";
  for (int round = 0; round < 20000; ++round) {
    std::string text = original;
    for (std::size_t i = 1 + rng.below(8); i-- > 0;) {
      const std::size_t at = rng.below(text.size());
      switch (rng.below(3)) {
        case 0:
          text[at] = alphabet[rng.below(alphabet.size())];
          break;
        case 1:
          text.erase(at, 1 + rng.below(10));
          break;
        default:
          text.insert(at, 1, alphabet[rng.below(alphabet.size())]);
      }
      if (text.empty()) break;
    }
    for (const auto& scan : read(text).scans) {
      ASSERT_TRUE(isFinite(scan.T_odom_base)) << text;
      ASSERT_TRUE(std::isfinite(scan.scan.stamp)) << text;
      ASSERT_FALSE(scan.scan.ranges.empty()) << text;
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
