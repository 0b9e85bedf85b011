// SPDX-License-Identifier: BSD-3-Clause
#include "map/landmark_map.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "map/floor_plan.hpp"
#include "map/landmark_file.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

class Landmarks : public testing::Test {
 protected:
  std::string write(const std::string& text) const {
    const std::string file = folder_.file("landmarks.yaml");
    std::ofstream(file) << text;
    return file;
  }

  void expectRefused(const std::string& text, const std::string& why) const {
    const std::string file = write(text);
    EXPECT_THAT([&] { loadLandmarks(file); },
                ThrowsMessage<std::invalid_argument>(
                    testing::AllOf(HasSubstr("landmark map '" + file + "'"), HasSubstr(why))))
        << text;
  }

  TempFolder folder_;
};

TEST_F(Landmarks, ThatLookTheSameAreCandidatesForOneSighting) {
  const LandmarkMap map =
      loadLandmarks(write("landmarks:\n  - {id: 0, at: [1, 2]}\n  - {id: 3, at: [-4, 0.5]}\n"
                          "  - {id: 0, at: [7, 8]}\n"));
  ASSERT_THAT(map.all(), SizeIs(3));
  ASSERT_THAT(map.candidates(0), SizeIs(2));
  EXPECT_EQ(map.candidates(0)[1], Eigen::Vector2d(7, 8));
  ASSERT_THAT(map.candidates(3), SizeIs(1));
  EXPECT_EQ(map.candidates(3)[0], Eigen::Vector2d(-4, 0.5));
  EXPECT_THAT(map.candidates(-1), SizeIs(3));
  EXPECT_THAT(map.candidates(5), SizeIs(0));
}

TEST_F(Landmarks, MayBePartOfAFloorPlan) {
  const std::string file =
      write("outline: [[0, 0], [5, 0], [5, 4], [0, 4]]\nlandmarks: [{id: 1, at: [2, 3]}]\n");
  EXPECT_THAT(loadLandmarks(file).all(), SizeIs(1));
  const FloorPlan plan = loadFloorPlan(file);
  ASSERT_THAT(plan.landmarks, SizeIs(1));
  EXPECT_EQ(plan.landmarks[0].id, 1);
  EXPECT_EQ(plan.landmarks[0].place, Eigen::Vector2d(2, 3));
}

TEST_F(Landmarks, MayBeReflectors) {
  const LandmarkMap map = loadLandmarks(
      write("landmarks:\n  - {id: 0, at: [1, 2]}\n  - {id: 0, at: [3, 4], reflector: 0.25}\n"));
  ASSERT_THAT(map.all(), SizeIs(2));
  EXPECT_EQ(map.all()[0].reflector, 0.0);
  EXPECT_EQ(map.all()[1].reflector, 0.25);
}

TEST_F(Landmarks, ThatAreNoneAreRefusedByEntry) {
  expectRefused("posts: []\n", "'landmarks': expected a list");
  expectRefused("landmarks: []\n", "'landmarks': expected a list");
  expectRefused("landmarks: 3\n", "'landmarks': expected a list");
  expectRefused("3\n", "'landmarks': expected a list");
  const std::string good = "landmarks:\n  - {id: 0, at: [1, 2]}\n  - ";
  for (const char* entry :
       {"{id: -1, at: [1, 2]}", "{id: a, at: [1, 2]}", "{id: 1}", "{id: 1, at: [1]}",
        "{id: 1, at: [1, .nan]}", "{id: 1, at: 3}", "{id: 1, at: [1, 2], colour: red}", "[1, 2]",
        "{id: 1, at: [1, 1e9]}", "{id: 1, reflector: 0.1}"}) {
    expectRefused(good + entry + "\n", "'landmarks[1]': expected {id: whole number");
  }
  EXPECT_THAT([] { loadLandmarks("/no/such/file.yaml"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("/no/such/file.yaml")));
}

}  // namespace
}  // namespace adaptive_localization
