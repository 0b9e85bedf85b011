// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/carmen_log.hpp"

#include <gmock/gmock.h>

#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <fstream>
#include <sstream>

#include "adaptive_localization/rng.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

const char kSmallLog[] =
    "# CARMEN Logfile\n"
    "PARAM robot_frontlaser_offset 0.25 host 0\n"
    "PARAM robot_front_laser_max 50.0 host 0\n"
    "ODOM 0 0 0 0 0 0 10.0 host 0.0\n"
    "FLASER 3 1.0 2.0 81.9 0.25 0 0 0 0 0 10.1 host 0.1\n"
    "RLASER 3 1.0 2.0 3.0 0 0 0 0 0 0 10.1 host 0.1\n"
    "FLASER 3 1.5 2.5 3.5 1.25 2 0 1 2 0.5 10.2 host 0.2\n";

Log read(const std::string& text, const LogRequest& request = {}) {
  std::istringstream input(text);
  return readCarmenLog(input, request);
}

LogRequest requestFor(const std::string& file) {
  LogRequest request;
  request.file = file;
  return request;
}

TEST(CarmenLog, ReadsFlaser) {
  const Log log = read(kSmallLog);
  EXPECT_THAT(log.warnings, IsEmpty());
  EXPECT_EQ(log.skipped, 0);
  ASSERT_EQ(log.scans.size(), 2U);
  const LogScan& scan = log.scans[1];
  EXPECT_DOUBLE_EQ(scan.scan.stamp, 10.2);
  EXPECT_THAT(scan.scan.ranges, ElementsAre(1.5F, 2.5F, 3.5F));
  EXPECT_DOUBLE_EQ(scan.scan.range_max, 50.0);
  EXPECT_DOUBLE_EQ(scan.T_odom_base.x, 1.0);
  EXPECT_DOUBLE_EQ(scan.T_odom_base.y, 2.0);
  EXPECT_DOUBLE_EQ(scan.T_odom_base.theta, 0.5);
  EXPECT_DOUBLE_EQ(scan.mount.position.x(), 0.25);
  EXPECT_FALSE(scan.T_map_base);
}

struct Fan {
  int beams;
  double increment_deg, last_deg;
};

class CarmenFan : public testing::TestWithParam<Fan> {};

TEST_P(CarmenFan, SpansHalfACircle) {
  std::string line = "FLASER " + std::to_string(GetParam().beams);
  for (int i = 0; i < GetParam().beams; ++i) line += " 1.0";
  const Log log = read(line + " 0 0 0 0 0 0 1.0 host 1.0\n");
  ASSERT_EQ(log.scans.size(), 1U);
  const LaserScan& scan = log.scans[0].scan;
  const double last = scan.angle_min + (GetParam().beams - 1) * scan.angle_increment;
  EXPECT_NEAR(scan.angle_min, -kPi / 2, 1e-12);
  EXPECT_NEAR(scan.angle_increment * 180 / kPi, GetParam().increment_deg, 1e-12);
  EXPECT_NEAR(last * 180 / kPi, GetParam().last_deg, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Lasers, CarmenFan,
                         testing::Values(Fan{180, 1.0, 89.0}, Fan{181, 1.0, 90.0},
                                         Fan{360, 0.5, 89.5}, Fan{361, 0.5, 90.0}));

TEST(CarmenLog, ReadsRobotLaser) {
  const Log log = read(
      "PARAM robot_frontlaser_offset 0.1 host 0\n"
      "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 2 7 8 0.1 0 0 4 5 6 0 0 0.3 0.3 1e10 "
      "99.5 host 9.5\n");
  EXPECT_THAT(log.warnings, IsEmpty());
  ASSERT_EQ(log.scans.size(), 1U);
  const LogScan& scan = log.scans[0];
  EXPECT_DOUBLE_EQ(scan.scan.angle_min, -1.5);
  EXPECT_DOUBLE_EQ(scan.scan.angle_increment, 1.5);
  EXPECT_DOUBLE_EQ(scan.scan.range_max, 20.0);
  EXPECT_DOUBLE_EQ(scan.scan.stamp, 99.5);
  EXPECT_DOUBLE_EQ(scan.T_odom_base.x, 4.0);
  EXPECT_NEAR(scan.T_odom_base.theta, 6.0 - 2.0 * kPi, 1e-12);
}

TEST(CarmenLog, TakesOneKindOfScanOnly) {
  const Log log = read(
      "FLASER 2 1 2 0 0 0 0 0 0 1.0 host 1.0\n"
      "ROBOTLASER1 0 -1.5 3.0 3.0 20.0 0.01 0 2 1 2 0 0 0 0 0 0 0 0 0 0.3 0.3 1e10 1.0 host 1\n");
  EXPECT_EQ(log.scans.size(), 1U);
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

TEST(CarmenLog, SaysThatTheMountIsAGuess) {
  const Log log = read("FLASER 2 1 2 0 0 0 0 0 0 1.0 host 1.0\n");
  EXPECT_THAT(log.warnings, Contains(HasSubstr("robot_frontlaser_offset")));
}

TEST(CarmenLog, SpreadsLateStampsBetweenTheirNeighbours) {
  std::string text = "PARAM robot_frontlaser_offset 0 host 0\n";
  for (const char* stamp : {"5.0", "1.0", "6.0", "7.0", "4.0", "4.0", "8.0"}) {
    text += std::string("FLASER 2 1 2 0 0 0 0 0 0 ") + stamp + " host 1\n";
  }
  const Log log = read(text);
  std::vector<double> stamps;
  for (const auto& scan : log.scans) stamps.push_back(scan.scan.stamp);
  EXPECT_THAT(stamps, ElementsAre(1.0, 1.0, 2.0, 3.0, 4.0, 4.0, 8.0));
  EXPECT_THAT(log.warnings, ElementsAre(AllOf(HasSubstr("later than those of the scans after them"),
                                              HasSubstr(": 3"))));
}

TEST(CarmenLog, CutsByStamps) {
  LogRequest request;
  request.begin = 10.2;
  const Log log = read(kSmallLog, request);
  ASSERT_EQ(log.scans.size(), 1U);
  EXPECT_DOUBLE_EQ(log.scans[0].scan.stamp, 10.2);
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
