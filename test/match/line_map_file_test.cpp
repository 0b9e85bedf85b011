// SPDX-License-Identifier: BSD-3-Clause
// The option line_map: floor plans that are matched with, and those that are not.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <stdexcept>

#include "adaptive_localization/localizer/localizer.hpp"
#include "adaptive_localization/map/map_io.hpp"
#include "match/line_map.hpp"
#include "match/scan_matcher.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

std::string planWith(const std::string& text) {
  const std::string file = testing::TempDir() + "line_map_file_test.yaml";
  std::ofstream(file) << text;
  return file;
}

const Lattice kLattice(100, 60, 0.05, {-1.0, -1.0, 0.3});  // 5 x 3 m

TEST(LineMapFile, OfShippedWorldsIsOnTheirMaps) {
  for (const std::string name : {"complex", "corridor", "expansion", "hall", "maze", "office",
                                 "office_moved", "simple", "symmetric", "torus", "warehouse"}) {
    const std::string folder = std::string(SOURCE_DIR) + "/maps/" + name;
    const auto map = std::make_shared<const OccupancyGrid>(loadMap(folder + "/map.yaml"));
    EXPECT_GT(loadLineMap(folder + "/world.yaml", map->lattice()).size(), 3U) << name;
    MatchOptions options;
    options.line_map = folder + "/world.yaml";
    SurfaceMaps surfaces(map, MapQuality(*map));
    EXPECT_NO_THROW(makeScanMatcher(options, surfaces)) << name;
  }
}

TEST(LineMapFile, OfWhichOneWallIsOnTheMapWillDo) {
  const auto file = planWith("outline: [[0, 0], [90, 0], [90, 90], [0, 90]]\n");
  EXPECT_EQ(loadLineMap(file, kLattice).size(), 4U);
}

TEST(LineMapFile, ElsewhereIsRefused) {
  for (const std::string outline : {"[[100, 50], [104, 50], [104, 53]]",  // another building
                                    "[[-90, -90], [90, -90], [90, 90], [-90, 90]]"}) {  // round it
    const auto file = planWith("outline: " + outline + "\n");
    const std::string error = errorOf([&] { loadLineMap(file, kLattice); });
    EXPECT_THAT(error, AllOf(HasSubstr("option 'line_map'"), HasSubstr(file),
                             HasSubstr("none of its walls"), HasSubstr("on the map")));
  }
  const auto file = planWith("outline: [[100, 50], [104, 50], [104, 53]]\n");
  EXPECT_THAT(errorOf([&] { loadLineMap(file, kLattice); }),
              AllOf(HasSubstr("(x from 100 to 104, y from 50 to 53 m)"), HasSubstr("x from -1.8")));
}

TEST(LineMapFile, ErrorsNameTheOption) {
  const auto expect = [](const std::string& file) {
    EXPECT_THAT(errorOf([&] { loadLineMap(file, kLattice); }),
                AllOf(HasSubstr("option 'line_map'"), HasSubstr(file)));
  };
  expect("/does/not/exist.yaml");
  for (const char* text : {"walls: []\n", "[", "image: map.pgm\n"}) expect(planWith(text));
}

/// A localizer keeps what it has, of options and of maps.
TEST(LineMapFile, RefusedChangesNothing) {
  Parameters given;
  given.set("filter", OptionValue(std::string("ekf_icp")));
  const auto map = asymmetricWorld();
  const auto plan = planWith("outline: [[0.5, 0.5], [9.5, 0.5], [9.5, 4.5], [0.5, 4.5]]\n");
  given.set("line_map", OptionValue(plan));
  for (const std::string landmarks : {"hits", "lines"}) {
    given.set("ekf_landmarks", OptionValue(landmarks));
    Localizer localizer(given, map);
    localizer.reset(Gaussian2{{1.0, 1.0, 0.0}, 0.01 * Eigen::Matrix3d::Identity()});
    const auto seen = ToyLaser{91}.observe(map, {1.0, 1.0, 0.0});
    localizer.update({}, seen);
    const auto options = localizer.effectiveOptions();

    Parameters bad = given;
    bad.set("line_map", OptionValue(std::string("/does/not/exist.yaml")));
    EXPECT_THAT(errorOf([&] { localizer.configure(bad); }), HasSubstr("option 'line_map'"));
    EXPECT_THAT(errorOf([&] {
                  localizer.setMap(asymmetricWorld({500.0, 0.0, 0.0}));
                }),
                HasSubstr("option 'line_map'"));
    EXPECT_EQ(localizer.effectiveOptions().size(), options.size());
    for (const auto& option : localizer.effectiveOptions()) {
      if (option.key == "line_map") {
        EXPECT_EQ(toText(option.value), plan);
      }
    }
    localizer.requestUpdate();
    EXPECT_TRUE(localizer.update({}, seen).updated);
    EXPECT_TRUE(localizer.match()->isGood()) << toText(localizer.match()->fault);
  }
}

}  // namespace
}  // namespace adaptive_localization
