// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/place_rows.hpp"

#include <gmock/gmock.h>

namespace adaptive_localization {
namespace {

NamedPlace at(double x, double theta = 0.0) {
  return {{x, 0.0, theta}, 0.5};
}

std::vector<double> xs(const PlaceRows& rows) {
  std::vector<double> all;
  for (const auto& row : rows.rows()) all.push_back(row.place.pose.x);
  return all;
}

std::vector<bool> areThere(const PlaceRows& rows) {
  std::vector<bool> all;
  for (const auto& row : rows.rows()) all.push_back(row.is_there);
  return all;
}

using testing::ElementsAre;

}  // namespace

TEST(PlaceRows, StandAsTheyCome) {
  PlaceRows rows(3);
  rows.update({at(1.0), at(2.0)}, false);
  EXPECT_THAT(xs(rows), ElementsAre(1.0, 2.0));
  rows.update({at(2.0), at(1.0), at(3.0), at(4.0)}, false);
  EXPECT_THAT(xs(rows), ElementsAre(2.0, 1.0, 3.0)) << "as many as there may be";
  rows.update({}, false);
  EXPECT_THAT(xs(rows), ElementsAre());
}

TEST(PlaceRows, StayWhileTheyAreHeld) {
  PlaceRows rows(3);
  rows.update({at(1.0), at(3.0)}, true);
  rows.update({at(3.2), at(1.1), at(5.0)}, true);
  EXPECT_THAT(xs(rows), ElementsAre(1.1, 3.2, 5.0));
  EXPECT_THAT(areThere(rows), ElementsAre(true, true, true));
}

TEST(PlaceRows, ThoseThatAreGoneLeaveTheirRow) {
  PlaceRows rows(3);
  rows.update({at(1.0), at(3.0)}, true);
  rows.update({at(3.0)}, true);
  EXPECT_THAT(xs(rows), ElementsAre(1.0, 3.0));
  EXPECT_THAT(areThere(rows), ElementsAre(false, true));
  rows.update({at(3.0), at(1.0)}, true);
  EXPECT_THAT(areThere(rows), ElementsAre(true, true));
  rows.update({at(3.0)}, false);
  EXPECT_THAT(xs(rows), ElementsAre(3.0));
}

TEST(PlaceRows, AnotherHeadingIsAnotherPlace) {
  PlaceRows rows(3);
  rows.update({at(1.0, 3.1)}, true);
  rows.update({at(1.0, 0.0), at(1.0, -3.1)}, true);
  ASSERT_EQ(rows.rows().size(), 2U);
  EXPECT_EQ(rows.rows()[0].place.pose.theta, -3.1);
  EXPECT_EQ(rows.rows()[1].place.pose.theta, 0.0);
}

TEST(PlaceRows, OneRowHoldsOnePlace) {
  PlaceRows rows(3);
  rows.update({at(1.0)}, true);
  rows.update({at(1.1), at(1.2)}, true);
  EXPECT_THAT(xs(rows), ElementsAre(1.1, 1.2));
}

}  // namespace adaptive_localization
