// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/map_io.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <stdexcept>

#include "adaptive_localization/core/rng.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char* const kYaml =
    "image: map.pgm\nresolution: 0.05\norigin: [-1.0, 2.0, 0.5]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// Three columns, two rows; the image's first row is the map's last.
const std::string kImage =
    std::string("P5\n3 2\n255\n") + "\xfe\xcd" + std::string(1, '\0') + "\x60" + "\xc8\xff";

class MapIo : public ::testing::Test {
 protected:
  OccupancyGrid load(const std::string& yaml) { return loadMap(folder_.write("map.yaml", yaml)); }

  std::string errorOf(const std::string& yaml) {
    try {
      load(yaml);
    } catch (const MapFileError& error) {
      reason_ = error.reason();
      return error.what();
    }
    return "no error";
  }

  static std::string with(const std::string& key, const std::string& value) {
    std::string yaml = kYaml;
    const auto start = yaml.find(key + ":");
    yaml.erase(start, yaml.find('\n', start) + 1 - start);
    return value.empty() ? yaml : yaml + key + ": " + value + "\n";
  }

  TempFolder folder_;
  std::optional<MapFileError::Reason> reason_;
};

TEST_F(MapIo, TrinaryMapIsReadBottomRowFirst) {
  folder_.write("map.pgm", kImage);
  const OccupancyGrid map = load(kYaml);
  EXPECT_EQ(map.lattice(), Lattice(3, 2, 0.05, {-1.0, 2.0, 0.5}));
  // 0x60: occupancy 0.62, between the thresholds; 0xc8: 0.216, too; 0xcd: 0.19608 is just above
  // free
  EXPECT_THAT(map.cells(), ElementsAre(-1, -1, 0, 0, -1, 100));
}

TEST_F(MapIo, ImageInsteadOfTheYamlFileIsToldApart) {
  for (const std::string& image : {kImage, std::string("P2\n1 1\n255\n0\n")}) {
    EXPECT_THAT(errorOf(image), HasSubstr("got an image, expected a YAML file with 'image: ...'"));
    EXPECT_EQ(reason_, MapFileError::Reason::kMetadata);
  }
}

TEST_F(MapIo, ScaleModeGradesBetweenTheThresholds) {
  folder_.write("map.pgm", kImage);
  const OccupancyGrid map = load(std::string(kYaml) + "mode: scale\n");
  // 1 + 98 (0.62353 - 0.196) / 0.454 = 93.3; 1 + 98 (0.21569 - 0.196) / 0.454 = 5.2
  EXPECT_THAT(map.cells(), ElementsAre(93, 5, 0, 0, 1, 100));
}

TEST_F(MapIo, RawModeTakesTheBytes) {
  folder_.write("map.pgm", std::string("P5\n4 1\n255\n") + std::string(1, '\0') + "\x32\x64\xff");
  const OccupancyGrid map = load(std::string(kYaml) + "mode: raw\n");
  EXPECT_THAT(map.cells(), ElementsAre(0, 50, 100, -1));
}

TEST_F(MapIo, NegateSwapsBlackAndWhite) {
  folder_.write("map.pgm", kImage);
  EXPECT_THAT(load(with("negate", "1")).cells(), ElementsAre(-1, 100, 100, 100, 100, 0));
  EXPECT_THAT(load(with("negate", "true")).cells(), ElementsAre(-1, 100, 100, 100, 100, 0));
}

TEST_F(MapIo, AlphaIsAChannelInTrinaryModeAndUnknownInScaleMode) {
  cv::Mat image(1, 3, CV_8UC4);
  image.at<cv::Vec4b>(0, 0) = {0, 0, 0, 255};        // trinary: mean 64, occupied
  image.at<cv::Vec4b>(0, 1) = {120, 150, 180, 0};    // trinary: mean 112.5, scale: unknown
  image.at<cv::Vec4b>(0, 2) = {120, 150, 180, 255};  // trinary: mean 176, scale: mean 150
  cv::imwrite(folder_.file("map.png"), image);
  const std::string yaml = with("image", "map.png");
  EXPECT_THAT(load(yaml).cells(), ElementsAre(100, -1, -1));
  EXPECT_THAT(load(yaml + "mode: scale\n").cells(), ElementsAre(100, -1, 47));
}

TEST_F(MapIo, ColourIsAveraged) {
  cv::imwrite(folder_.file("map.png"), cv::Mat(1, 1, CV_8UC3, cv::Scalar(255, 0, 255)));
  EXPECT_THAT(load(with("image", "map.png") + "mode: scale\n").cells(), ElementsAre(30));
}

/// A PNG file of the greys 0, 205 and 254, of which 205 is transparent (chunk tRNS).
TEST_F(MapIo, AGreyValueThatIsTransparentIsThatValue) {
  const char png[] =
      "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x03"
      "\x00\x00\x00\x01\x08\x00\x00\x00\x00\x3e\x8b\x4b\x68\x00\x00\x00\x02\x74\x52\x4e"
      "\x53\x00\xcd\x93\x46\x73\x35\x00\x00\x00\x0c\x49\x44\x41\x54\x78\x9c\x63\x60\x38"
      "\xfb\x0f\x00\x02\x9c\x01\xcc\xc9\x8a\xee\xba\x00\x00\x00\x00\x49\x45\x4e\x44\xae"
      "\x42\x60\x82";
  folder_.write("map.png", std::string(png, sizeof(png) - 1));
  EXPECT_THAT(load(with("image", "map.png")).cells(), ElementsAre(100, -1, 0));
  EXPECT_THAT(load(with("image", "map.png") + "mode: scale\n").cells(), ElementsAre(100, 1, 0));
}

TEST_F(MapIo, SixteenBitsAreReadAsEight) {
  cv::imwrite(folder_.file("map.png"), cv::Mat(1, 1, CV_16UC1, cv::Scalar(50 * 257)));
  EXPECT_THAT(load(with("image", "map.png") + "mode: raw\n").cells(), ElementsAre(50));
}

TEST_F(MapIo, NetpbmIsReadAsTextAndWithSixteenBits) {
  folder_.write("map.pgm", "P2\n# a comment\n3 1\n100\n0 50 100\n");
  // 50 of 100 is 127 of 255: 1 + 98 (0.50196 - 0.196) / 0.454 = 67.05
  EXPECT_THAT(load(std::string(kYaml) + "mode: scale\n").cells(), ElementsAre(100, 67, 0));
  folder_.write("map.pgm", "P5\n2 1\n65535\n\x32\x32\x64\x64");
  EXPECT_THAT(load(std::string(kYaml) + "mode: raw\n").cells(), ElementsAre(50, 100));
}

TEST_F(MapIo, ImageIsKnownByItsContentAndNotByItsName) {
  cv::imwrite(folder_.file("grey.png"), cv::Mat(1, 1, CV_8UC1, cv::Scalar(50)));
  cv::imwrite(folder_.file("grey.bmp"), cv::Mat(1, 1, CV_8UC1, cv::Scalar(50)));
  cv::imwrite(folder_.file("grey.jpg"), cv::Mat(8, 8, CV_8UC1, cv::Scalar(50)));
  for (const char* name : {"grey.png", "grey.bmp", "grey.jpg"}) {
    std::filesystem::copy_file(folder_.file(name), folder_.file("map.pgm"),
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_THAT(load(std::string(kYaml) + "mode: raw\n").cells(), Each(50)) << name;
  }
}

TEST_F(MapIo, NamesMayHaveAnyLetters) {
  folder_.write("Büro – 2. Stock.pgm", kImage);
  EXPECT_EQ(load(with("image", "Büro – 2. Stock.pgm")).cells().size(), 6u);
}

TEST_F(MapIo, AbsoluteImagePathIsTakenAsItIs) {
  const std::string image = folder_.write("map.pgm", kImage);
  TempFolder elsewhere;
  EXPECT_EQ(loadMap(elsewhere.write("m.yaml", with("image", image))).cells().size(), 6u);
}

TEST_F(MapIo, SavedMapIsReadBackTheSame) {
  const OccupancyGrid saved(Lattice(3, 2, 0.025, {-12.345, 6.7, -1.25}), {0, 100, -1, 0, 0, 100});
  saveMap(saved, folder_.file("a: map"));
  const OccupancyGrid loaded = loadMap(folder_.file("a: map.yaml"));
  EXPECT_EQ(loaded.lattice(), saved.lattice());
  EXPECT_EQ(loaded.cells(), saved.cells());
}

TEST_F(MapIo, SavingNamesTheFileThatCannotBeWritten) {
  const OccupancyGrid map(Lattice(1, 1, 1.0, {}), {0});
  try {
    saveMap(map, folder_.file("no/such/folder"));
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no/such/folder.pgm"));
  }
}

TEST_F(MapIo, ErrorsNameFileKeyValueAndExpectation) {
  EXPECT_THAT(errorOf(kYaml), HasSubstr("map.pgm' cannot be opened"));
  EXPECT_EQ(reason_, MapFileError::Reason::kMissing);
  folder_.write("map.pgm", "this is no image");
  EXPECT_THAT(errorOf(kYaml), HasSubstr("map.pgm' is no image"));
  EXPECT_EQ(reason_, MapFileError::Reason::kImage);
  folder_.write("map.pgm", "P5\n1000000 1000000\n255\n");
  EXPECT_THAT(errorOf(kYaml), HasSubstr("map.pgm'"));
  folder_.write("map.pgm", kImage);
  EXPECT_EQ(errorOf(kYaml), "no error");
  for (const char* key :
       {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}) {
    EXPECT_THAT(errorOf(with(key, "")), HasSubstr("'" + std::string(key) + "' is missing"));
  }
  EXPECT_THAT(errorOf(with("resolution", "0")), HasSubstr("'resolution': got '0', expected a pos"));
  EXPECT_THAT(errorOf(with("resolution", ".nan")), HasSubstr("'resolution': got '.nan'"));
  EXPECT_THAT(errorOf(with("resolution", "fine")), HasSubstr("'resolution': got 'fine'"));
  EXPECT_THAT(errorOf(with("origin", "[0, .nan, 0]")), HasSubstr("'origin': got '[0, .nan, 0]'"));
  EXPECT_THAT(errorOf(with("origin", "[0, 0]")), HasSubstr("three finite numbers"));
  EXPECT_THAT(errorOf(with("origin", "[0, a, 0]")), HasSubstr("'origin': got '[0, a, 0]'"));
  EXPECT_THAT(errorOf(with("negate", "2")), HasSubstr("'negate': got '2', expected 0 or 1"));
  EXPECT_THAT(errorOf(with("free_thresh", "0.7")), HasSubstr("[0, occupied_thresh]"));
  EXPECT_THAT(errorOf(with("occupied_thresh", "65")), HasSubstr("'occupied_thresh': got '65'"));
  EXPECT_THAT(errorOf(std::string(kYaml) + "mode: fast\n"), HasSubstr("trinary, scale or raw"));
  EXPECT_THAT(errorOf("just a sentence"), HasSubstr("map.yaml': got no YAML map"));
  EXPECT_EQ(reason_, MapFileError::Reason::kMetadata);
  EXPECT_THAT(errorOf("image: [unclosed"), HasSubstr("map.yaml': yaml-cpp: error at line 1"));
}

TEST(LoadMap, MissingFileIsNamed) {
  try {
    loadMap("/no/such/map.yaml");
    FAIL() << "no error";
  } catch (const MapFileError& error) {
    EXPECT_STREQ(error.what(), "map file '/no/such/map.yaml' cannot be opened");
  }
}

TEST_F(MapIo, BrokenYamlGivesAMapOrAnError) {
  folder_.write("map.pgm", kImage);
  const std::string good = std::string(kYaml) + "mode: scale\n";
  const std::string alphabet = "-.:,[]{}#'\"&*!|> \n\t019eaimnor\x80";
  Rng rng(1);
  int rejected = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string yaml = good;
    for (std::size_t edits = 1 + rng.below(4); edits > 0; --edits) {
      yaml[rng.below(yaml.size())] = alphabet[rng.below(alphabet.size())];
    }
    try {
      EXPECT_EQ(load(yaml).cells().size(), 6u);
    } catch (const MapFileError& error) {
      EXPECT_THAT(error.what(), HasSubstr("map.yaml"));
      ++rejected;
    }
  }
  EXPECT_GT(rejected, 500);
}

}  // namespace
}  // namespace adaptive_localization
