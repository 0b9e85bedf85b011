// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "ros/point_markers.hpp"
#include "ros/status_markers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::SizeIs;
using visualization_msgs::Marker;

class SerMarker : public testing::Test {
 protected:
  std::shared_ptr<const OccupancyGrid> map_{asymmetricWorld()};
  Pose2 truth_{1.6, 1.4, 0.7};
  Scan scan_{ToyLaser{}.observe(map_, truth_).scan};
  EnergyGrid grid_{*map_, geometryOf(scan_, 10.0), EnergyGridOptions{}};

  Marker make(const Scan& scan, std::size_t most = 1000000) const {
    std_msgs::Header header;
    header.frame_id = "map";
    return serMarker(header, grid_, scan, most);
  }
};

TEST_F(SerMarker, HasTheRegionsCellsAmongThemTheTruths) {
  const Marker marker = make(scan_);
  EXPECT_EQ(marker.header.frame_id, "map");
  EXPECT_EQ(marker.type, Marker::POINTS);
  EXPECT_EQ(marker.action, Marker::ADD);
  std::set<std::size_t> cells;
  const auto region = grid_.similarTo(*grid_.energyOf(scan_));
  for (std::size_t i = region.begin; i < region.end; ++i) {
    const Pose2 pose = grid_.pose(i);
    cells.insert(map_->lattice().index(map_->lattice().cellAt({pose.x, pose.y})));
  }
  EXPECT_THAT(marker.points, SizeIs(cells.size()));
  EXPECT_THAT(marker.colors, SizeIs(marker.points.size()));
  double nearest = 1e9;
  for (const auto& point : marker.points) {
    nearest = std::min(nearest, std::hypot(point.x - truth_.x, point.y - truth_.y));
  }
  EXPECT_LT(nearest, 0.05);
}

TEST_F(SerMarker, GoesFromBlueOverGreenToRed) {
  const auto colours = make(scan_).colors;
  ASSERT_GT(colours.size(), 100U);
  // the region is sorted by falling energy
  EXPECT_GT(colours.front().r, colours.front().g);
  EXPECT_GT(colours.back().b, colours.back().g);
  float most_green = 0.0F;
  for (const auto& colour : colours) {
    EXPECT_EQ(colour.a, 1.0F);
    most_green = std::max(most_green, colour.g - colour.r);
  }
  EXPECT_GT(most_green, 0.35F);
}

TEST_F(SerMarker, IsThinnedOverTheWholeRegion) {
  const Marker all = make(scan_);
  const Marker thinned = make(scan_, 100);
  EXPECT_LE(thinned.points.size(), 100U);
  EXPECT_GT(thinned.points.size(), 50U);
  EXPECT_GT(thinned.colors.back().b, thinned.colors.back().g);
}

TEST_F(SerMarker, IsDeletedWhereTheRegionIsEmpty) {
  const double far = 9.99;
  Scan alien = scan_;
  alien.range.setConstant(static_cast<float>(far));
  alien.view.range.setConstant(static_cast<float>(far));
  Scan blind = scan_;
  for (auto* column : {&blind.x, &blind.y, &blind.range, &blind.bearing}) column->resize(0);
  blind.no_return_bearing.resize(0);
  blind.view.range.setConstant(std::nanf(""));
  for (const Scan& scan : {alien, blind}) {
    const Marker marker = make(scan);
    EXPECT_EQ(marker.action, Marker::DELETE);
    EXPECT_THAT(marker.points, SizeIs(0));
    EXPECT_EQ(marker.ns, "ser");
  }
}

Match matchOf(const Scan& scan) {
  Match match;
  match.T_map_base = {1.0, 2.0, 0.5};
  match.fits.assign(static_cast<std::size_t>(scan.hits()), 1);
  match.fits[2] = 0;
  return match;
}

TEST(MatchMarker, ShowsHitsInTheMapGreenIfTheyFit) {
  const Scan scan = ToyLaser{}.observe(asymmetricWorld(), {1.6, 1.4, 0.7}).scan;
  ASSERT_GT(scan.hits(), 5);
  const Match match = matchOf(scan);
  const Marker marker = matchMarker({}, &match, scan);
  EXPECT_EQ(marker.action, Marker::ADD);
  EXPECT_EQ(marker.type, Marker::POINTS);
  ASSERT_THAT(marker.points, SizeIs(static_cast<std::size_t>(scan.hits())));
  ASSERT_THAT(marker.colors, SizeIs(marker.points.size()));
  for (std::size_t i = 0; i < marker.points.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const Eigen::Vector2d hit = match.T_map_base * Eigen::Vector2d(scan.x[k], scan.y[k]);
    EXPECT_NEAR(marker.points[i].x, hit.x(), 1e-9);
    EXPECT_NEAR(marker.points[i].y, hit.y(), 1e-9);
    EXPECT_EQ(marker.colors[i].g > marker.colors[i].r, i != 2) << i;
    EXPECT_EQ(marker.colors[i].a, 1.0F);
  }
}

TEST(MatchMarker, NothingIsGreenInAMatchThatWasRefused) {
  const Scan scan = ToyLaser{}.observe(asymmetricWorld(), {1.6, 1.4, 0.7}).scan;
  Match match = matchOf(scan);
  match.fault = MatchFault::kOutliers;
  const Marker marker = matchMarker({}, &match, scan);
  ASSERT_THAT(marker.colors, SizeIs(static_cast<std::size_t>(scan.hits())));
  for (const auto& colour : marker.colors) EXPECT_GT(colour.r, colour.g);
  EXPECT_NE(marker.colors[1].g, marker.colors[2].g);
}

TEST(MatchMarker, IsDeletedWithoutAMatchOfThisScan) {
  const Scan scan = ToyLaser{}.observe(asymmetricWorld(), {1.6, 1.4, 0.7}).scan;
  Match other = matchOf(scan);
  other.fits.pop_back();
  for (const Match* match :
       {static_cast<const Match*>(nullptr), static_cast<const Match*>(&other)}) {
    const Marker marker = matchMarker({}, match, scan);
    EXPECT_EQ(marker.action, Marker::DELETE);
    EXPECT_THAT(marker.points, SizeIs(0));
    EXPECT_EQ(marker.ns, "match");
  }
  EXPECT_EQ(matchMarker({}, &other, Scan{}).action, Marker::DELETE);
}

Localization answerWith(Status status, std::size_t modes) {
  Localization answer;
  answer.status = status;
  answer.confidence = 0.5;
  answer.T_map_base = {1.0, 2.0, 0.3};
  for (std::size_t i = 0; i < modes; ++i) {
    Mode mode;
    mode.T_map_base = {1.0 + static_cast<double>(i), 2.0, 0.3};
    mode.mass = 1.0 / static_cast<double>(modes);
    answer.modes.push_back(mode);
  }
  std::reverse(answer.modes.begin(), answer.modes.end());
  return answer;
}

TEST(StatusMarkers, SayTheStatusAndTheOtherPlaces) {
  const auto markers = statusMarkers({}, answerWith(Status::kAmbiguous, 2), nullptr).markers;
  ASSERT_THAT(markers, SizeIs(3));
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(markers[1].text, "ambiguous 0.50");
  EXPECT_EQ(markers[2].text, "or here 0.50");
  EXPECT_DOUBLE_EQ(markers[2].pose.position.x, 2.0);
  EXPECT_NE(markers[1].id, markers[2].id);
  for (std::size_t i = 1; i < 3; ++i) EXPECT_EQ(markers[i].color.a, 1.0F);
}

TEST(StatusMarkers, SayWhyAScanWasNotMatched) {
  Match match;
  const auto textWith = [&](MatchFault fault) {
    match.fault = fault;
    return statusMarkers({}, answerWith(Status::kTracking, 1), &match).markers.at(1).text;
  };
  EXPECT_EQ(textWith(MatchFault::kNone), "tracking 0.50");
  EXPECT_EQ(textWith(MatchFault::kFewHits), "tracking 0.50\nnot matched: too few hits");
}

TEST(StatusMarkers, AreFewForManyPlacesAndNoneWithoutAPose) {
  EXPECT_THAT(statusMarkers({}, answerWith(Status::kGlobalizing, 500), nullptr).markers,
              SizeIs(22));
  EXPECT_THAT(statusMarkers({}, answerWith(Status::kTracking, 0), nullptr).markers, SizeIs(2));
  EXPECT_THAT(statusMarkers({}, answerWith(Status::kUninitialised, 3), nullptr).markers, SizeIs(1));
}

}  // namespace
}  // namespace adaptive_localization
