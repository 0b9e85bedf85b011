// SPDX-License-Identifier: BSD-3-Clause
// What a scan matcher refuses: scans and guesses, each with its fault, and options.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "scan_toys.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ScanMatcherFaults, TooFewHits) {
  const ScanMatcher matcher(with("line"), surfacesOf(roomLines()));
  Scan few = scanAt(kTruth, roomLines());
  for (auto* column : {&few.x, &few.y, &few.range, &few.bearing}) column->conservativeResize(10);
  EXPECT_NE(matcher.match(kTruth, few).fault, MatchFault::kFewHits);
  for (auto* column : {&few.x, &few.y, &few.range, &few.bearing}) column->conservativeResize(9);
  const Match match = matcher.match(kTruth, few);
  EXPECT_EQ(match.fault, MatchFault::kFewHits);
  EXPECT_THAT(match.T_map_base, PoseNear(kTruth, 0.0, 0.0));
  EXPECT_EQ(match.fits.size(), 9U);
}

TEST(ScanMatcherFaults, OutliersWhereNothingOfTheMapIsSeen) {
  Scan crowd = scanAt(kTruth, roomLines());
  crowd.x *= 0.4F;
  crowd.y *= 0.4F;
  const auto nothing =
      std::make_shared<const SurfaceMap>(Lattice(10, 10, 0.05, {}), std::vector<Segment>{});
  for (const auto& surfaces : {surfacesOf(roomLines()), nothing}) {
    EXPECT_EQ(ScanMatcher(with("line"), surfaces).match(kTruth, crowd).fault,
              MatchFault::kOutliers);
  }
}

/// Hits all round that lie beside walls by more than a narrow kernel forgives: each counts for
/// nearly nothing.
TEST(ScanMatcherFaults, SingularWhereNoHitCountsForMuch) {
  MatchOptions options = with("line");
  options.match_kernel = 1e-4;
  const Scan scan = scanAt(kTruth, roomLines(), 0.05);
  const Match match = ScanMatcher(options, surfacesOf(roomLines())).match(kTruth, scan);
  EXPECT_EQ(match.fault, MatchFault::kSingular);
  EXPECT_GT(match.inlier_ratio, 0.9);
  EXPECT_EQ(match.H.rows(), 0);
  EXPECT_TRUE(match.information().isZero(0.0));
}

TEST(ScanMatcherFaults, SingularWhereOutliersAreForgivenAndAllAre) {
  MatchOptions options = with("line");
  options.match_least_inliers = 0.0;
  Scan crowd = scanAt(kTruth, roomLines());
  crowd.x *= 0.1F;
  crowd.y *= 0.1F;
  const Match match = ScanMatcher(options, surfacesOf(roomLines())).match(kTruth, crowd);
  EXPECT_EQ(match.fault, MatchFault::kSingular);
  EXPECT_THAT(match.T_map_base, PoseNear(kTruth, 0.0, 0.0)) << "where it was guessed";
}

TEST(ScanMatcherFaults, NoGuess) {
  const ScanMatcher matcher(with("line"), surfacesOf(roomLines()));
  const Scan scan = scanAt(kTruth, roomLines());
  for (const double odd : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (const Pose2& guess : {Pose2{odd, 2.0, 0.0}, Pose2{2.0, odd, 0.0}, Pose2{2.0, 2.0, odd}}) {
      const Match match = matcher.match(guess, scan);
      EXPECT_EQ(match.fault, MatchFault::kNoGuess);
      EXPECT_TRUE(isFinite(match.T_map_base));
    }
  }
  const Match far = matcher.match({1e300, -1e300, 1e9}, scan);
  EXPECT_EQ(far.fault, MatchFault::kOutliers);
  EXPECT_TRUE(isFinite(far.T_map_base));
}

TEST(ScanMatcherFaults, EachHasItsText) {
  std::set<std::string> texts;
  for (const MatchFault fault :
       {MatchFault::kNone, MatchFault::kNoGuess, MatchFault::kFewHits, MatchFault::kOutliers,
        MatchFault::kSingular, MatchFault::kJump, MatchFault::kSlides}) {
    texts.insert(toText(fault));
    EXPECT_EQ(isRefusal(fault), fault != MatchFault::kNone && fault != MatchFault::kSlides);
  }
  EXPECT_EQ(texts.size(), 7U);
  EXPECT_EQ(texts.count("none"), 1U);
}

TEST(ScanMatcherOptions, TheReachDoesNotGrow) {
  MatchOptions options;
  options.match_reach = options.match_reach_end;
  EXPECT_NO_THROW(ScanMatcher(options, surfacesOf(roomLines())));
  options.match_reach = 0.1;
  try {
    const ScanMatcher matcher(options, surfacesOf(roomLines()));
    FAIL() << "was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("'match_reach': got '0.1'"),
                                    HasSubstr("at least match_reach_end, which is '0.15'")));
  }
}

}  // namespace
}  // namespace adaptive_localization
