// SPDX-License-Identifier: BSD-3-Clause
#include "map/floor_plan.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

FloorPlan load(const std::string& text) {
  const std::string file = testing::TempDir() + "floor_plan_test.yaml";
  std::ofstream(file) << text;
  return loadFloorPlan(file);
}

std::string errorOf(const std::string& text) {
  try {
    load(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

const std::string kOutline = "outline: [[0, 0], [4, 0], [4, 3]]\n";

TEST(FloorPlan, ReadsEveryKey) {
  const FloorPlan plan =
      load(kOutline + "wall_thickness: 0.2\nwalls: [[[1, 0], [1, 1], [2, 1]]]\n" +
           "solids: [[[3, 1], [3.5, 1], [3, 1.5]]]\nfurniture: [[[0, 0], [1, 0], [0, 1]]]\n" +
           "route: [[1, 1], [2, 2]]\nstart: [1, 2, 3]\n");
  EXPECT_EQ(plan.outline.size(), 3U);
  EXPECT_EQ(plan.wall_thickness, 0.2);
  ASSERT_EQ(plan.walls.size(), 2U);
  EXPECT_EQ(plan.walls[1].b, Eigen::Vector2d(2, 1));
  EXPECT_EQ(plan.solids.size(), 1U);
  EXPECT_EQ(plan.furniture.size(), 1U);
  EXPECT_EQ(plan.route.size(), 2U);
  ASSERT_TRUE(plan.start.has_value());
  EXPECT_EQ(plan.start->theta, 3.0);
}

TEST(FloorPlan, ReadsPaint) {
  const Paint paint = load(kOutline +
                           "paint:\n  line_width: 0.1\n  lines: [[[1, 0], [1, 1], [2, 1]]]\n"
                           "  circles: [[2, 1, 0.5]]\n  carpet: [4, 0, 0, 3]\n")
                          .paint;
  EXPECT_EQ(paint.line_width, 0.1);
  ASSERT_GT(paint.lines.size(), 12U);
  EXPECT_EQ(paint.lines[1].b, Eigen::Vector2d(2, 1));
  double length = 0.0;
  for (std::size_t i = 2; i < paint.lines.size(); ++i) {
    EXPECT_NEAR((paint.lines[i].a - Eigen::Vector2d(2, 1)).norm(), 0.5, 1e-12);
    length += (paint.lines[i].b - paint.lines[i].a).norm();
  }
  EXPECT_NEAR(length, kPi, 0.01);
  ASSERT_TRUE(paint.carpet.has_value());
  EXPECT_EQ(paint.carpet->low, Eigen::Vector2d(0, 0));
  EXPECT_EQ(paint.carpet->high, Eigen::Vector2d(4, 3));
}

TEST(FloorPlan, NamesThePaintThatIsWrong) {
  const auto error = [](const std::string& paint) { return errorOf(kOutline + "paint: " + paint); };
  EXPECT_THAT(error("white"), HasSubstr("'paint': expected keys and values"));
  EXPECT_THAT(error("{line: []}"), HasSubstr("'paint.line': expected one of line_width, lines"));
  EXPECT_THAT(error("{line_width: 0}"), HasSubstr("'paint.line_width'"));
  EXPECT_THAT(error("{lines: [[[0, 0]]]}"), HasSubstr("'paint.lines'"));
  EXPECT_THAT(error("{lines: [[[0, 0], [0, 0]]]}"), HasSubstr("'paint.lines'"));
  EXPECT_THAT(error("{circles: 1}"), HasSubstr("'paint.circles'"));
  EXPECT_THAT(error("{circles: [[0, 0, 0]]}"), HasSubstr("'paint.circles'"));
  EXPECT_THAT(error("{carpet: [0, 0]}"), HasSubstr("'paint.carpet'"));
}

TEST(FloorPlan, HasReflectorsOnlyWhereABeamCanEndOnThem) {
  const auto error = [](const std::string& at, const std::string& width = "0.1") {
    return errorOf(
        "outline: [[0, 0], [4, 0], [4, 3], [0, 3]]\nwall_thickness: 0.4\n"
        "walls: [[[2, 0], [2, 1]]]\nlandmarks: [{id: 0, at: " +
        at + ", reflector: " + width + "}]\n");
  };
  EXPECT_EQ(error("[4, 1]"), "no error");
  EXPECT_EQ(error("[2.2, 0.5]"), "no error");
  for (const char* at : {"[1, 1]", "[5, 1]", "[2, 0.5]"}) {
    EXPECT_THAT(error(at), HasSubstr("'landmarks[0]': expected a reflector on the surface"));
  }
  EXPECT_EQ(error("[2, 0.5]", "0.5"), "no error") << "wider than the wall";
  for (const char* width : {"0", "-0.1", "true", ".nan", "10"}) {
    EXPECT_THAT(error("[4, 1]", width), HasSubstr("'landmarks[0]': expected reflector: a width"));
  }
}

TEST(FloorPlan, NamesTheKeyThatIsWrong) {
  EXPECT_THAT(errorOf("walls: []"), HasSubstr("'outline'"));
  EXPECT_THAT(errorOf("outline: [[0, 0], [1, 0]]"), HasSubstr("at least 3 points"));
  EXPECT_THAT(errorOf("outline: [[0, 0], [1, 0], [.nan, 1]]"), HasSubstr("'outline'"));
  EXPECT_THAT(errorOf("outline: 7"), HasSubstr("'outline'"));
  EXPECT_THAT(errorOf(kOutline + "walls: [[[0, 0]]]"), HasSubstr("'walls'"));
  EXPECT_THAT(errorOf(kOutline + "walls: [[[0, 0], [0, 0]]]"), HasSubstr("'walls'"));
  EXPECT_THAT(errorOf(kOutline + "wall_thickness: thick"), HasSubstr("'wall_thickness'"));
  EXPECT_THAT(errorOf(kOutline + "solids: 3"), HasSubstr("'solids'"));
  EXPECT_THAT(errorOf(kOutline + "route: [1, 2]"), HasSubstr("'route'"));
  EXPECT_THAT(errorOf(kOutline + "start: [1, 2]"), HasSubstr("'start'"));
  EXPECT_THAT(errorOf("["), HasSubstr("floor_plan_test.yaml"));
}

TEST(FloorPlan, RefusesUnknownKeysAndNamesTheKnownOnes) {
  EXPECT_THAT(errorOf(kOutline + "wall: [[[1, 0], [1, 1]]]\n"),
              HasSubstr("'wall': expected one of outline, wall_thickness, walls, solids, "
                        "furniture, route, start, paint, landmarks"));
  EXPECT_THAT(errorOf("image: map.pgm\n"), HasSubstr("'image': expected one of outline"));
  EXPECT_THAT(errorOf(kOutline + "[1, 2]: 3\n"), HasSubstr("floor_plan_test.yaml"));
}

TEST(FloorPlan, RefusesAnOutlineRoundNothing) {
  for (const std::string outline :
       {"[[0, 0], [4, 0], [2, 0]]", "[[0, 0], [0, 0], [0, 0]]", "[[0, 0], [0.1, 0.3], [0.2, 0.6]]",
        "[[1, 1], [3, 1], [3, 1], [1, 1]]"}) {
    EXPECT_THAT(errorOf("outline: " + outline),
                HasSubstr("'outline': expected points round an area"))
        << outline;
  }
  EXPECT_EQ(errorOf("outline: [[0, 3], [4, 0], [0, 0]]"), "no error") << "clockwise";
}

TEST(FloorPlan, OfAllShippedWorldsIsRead) {
  for (const std::string name :
       {"complex", "corridor", "expansion", "hall", "maze", "office", "office_moved", "robocup",
        "simple", "symmetric", "torus", "warehouse"}) {
    EXPECT_GT(loadFloorPlan(SOURCE_DIR "/maps/" + name + "/world.yaml").route.size(), 3U) << name;
  }
}

TEST(FloorPlan, DamagedFilesAreRefusedOrReadButNeverCrash) {
  std::ostringstream original;
  original << std::ifstream(SOURCE_DIR "/maps/maze/world.yaml").rdbuf();
  Rng rng(5);
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    std::string text = original.str();
    for (int i = 0; i < 3; ++i) text[rng.below(text.size())] = static_cast<char>(rng.below(128));
    if (errorOf(text) != "no error") ++refused;
  }
  EXPECT_GT(refused, 30);
}

const FloorPlan kRoom = [] {
  FloorPlan plan;
  plan.outline = {{0, 0}, {0, 4}, {6, 4}, {6, 0}};  // clockwise
  return plan;
}();

double lengthOf(const std::vector<Segment>& surfaces) {
  double sum = 0.0;
  for (const auto& surface : surfaces) sum += (surface.b - surface.a).norm();
  return sum;
}

/// The surface through a point, seen from a free place on its left.
MATCHER_P2(HasSurface, through, free, "") {
  return std::any_of(arg.begin(), arg.end(), [&](const Segment& surface) {
    const Eigen::Vector2d along = surface.b - surface.a;
    const Eigen::Vector2d across = free - through;
    return distance(surface, through) < 1e-9 && along.x() * across.y() > along.y() * across.x();
  });
}

using Point = Eigen::Vector2d;

TEST(SurfacesOf, ARoomAreItsWallsSeenFromWithin) {
  const auto surfaces = surfacesOf(kRoom);
  EXPECT_EQ(surfaces.size(), 4U);
  EXPECT_NEAR(lengthOf(surfaces), 20.0, 1e-9);
  for (const Point& middle : {Point(0, 2), Point(3, 4), Point(6, 2), Point(3, 0)}) {
    EXPECT_THAT(surfaces, HasSurface(middle, Point(3, 2)));
  }
}

TEST(SurfacesOf, AWallThatMeetsTheOutlineHidesPartOfIt) {
  FloorPlan plan = kRoom;
  plan.wall_thickness = 0.2;
  plan.walls = {{{3, 0}, {3, 2}}};
  const auto surfaces = surfacesOf(plan);
  // 20 m round the room less the 0.2 m under the wall, two faces of 2.1 m and an end of 0.2 m.
  EXPECT_NEAR(lengthOf(surfaces), 20.0 - 0.2 + 2 * 2.1 + 0.2, 1e-6);
  EXPECT_EQ(surfaces.size(), 8U);
  EXPECT_THAT(surfaces, HasSurface(Point(2.9, 1), Point(1, 1)));
  EXPECT_THAT(surfaces, HasSurface(Point(3.1, 1), Point(5, 1)));
  EXPECT_THAT(surfaces, HasSurface(Point(3, 2.1), Point(3, 3)));
}

TEST(SurfacesOf, NothingIsSeenBetweenSolidsThatTouch) {
  FloorPlan plan = kRoom;
  plan.solids = {{{1, 1}, {2, 1}, {2, 2}, {1, 2}},
                 {{2, 1}, {3, 1}, {3, 2}, {2, 2}},
                 {{1.5, 1}, {2.5, 1}, {2.5, 2}, {1.5, 2}},
                 {{4, 1}, {9, 1}, {9, 2}, {4, 2}}};  // reaches out of the room
  const auto surfaces = surfacesOf(plan);
  EXPECT_NEAR(lengthOf(surfaces), 20.0 + 6.0 + (2.0 + 2.0 + 1.0) - 1.0, 1e-6);
  EXPECT_EQ(surfaces.size(), 4U + 1U + 4U + 3U);
}

TEST(SurfacesOf, ABendsInsideIsHidden) {
  FloorPlan plan = kRoom;
  plan.wall_thickness = 0.2;
  plan.walls = {{{2, 1}, {4, 1}}, {{4, 1}, {4, 3}}};
  EXPECT_NEAR(lengthOf(surfacesOf(plan)), 20.0 + 2 * (2.2 + 2.2), 1e-6);
  EXPECT_EQ(surfacesOf(plan).size(), 4U + 6U);
}

}  // namespace
}  // namespace adaptive_localization
