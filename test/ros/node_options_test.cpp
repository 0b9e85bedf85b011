// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node_options.hpp"

#include <gmock/gmock.h>

#include <map>

#include "ros/places_maker.hpp"

namespace adaptive_localization {
namespace {

using testing::IsEmpty;

std::map<std::string, std::string> changed(const std::map<std::string, std::string>& given) {
  Parameters parameters;
  for (const auto& [key, value] : given) parameters.set(key, value);
  std::map<std::string, std::string> values;
  for (const auto& option : changedOptions(withCacheDir(parameters))) {
    values[option.key] = toText(option.value);
  }
  return values;
}

using Values = std::map<std::string, std::string>;

TEST(ChangedOptions, AreNoneWhereNothingOrADefaultIsGiven) {
  EXPECT_THAT(changed({}), IsEmpty());
  EXPECT_THAT(changed({{"laser_max_beams", "180"}, {"start", "pose"}, {"filter", "sa_kld"}}),
              IsEmpty());
  EXPECT_THAT(changed({{"refine", "true"}}), IsEmpty()) << "the preset's value";
}

TEST(ChangedOptions, AreThoseOfNodeAndLocalizerWithOtherValues) {
  const Values given{{"tf_rate", "20"}, {"laser_max_beams", "30"}, {"refine", "false"}};
  EXPECT_EQ(changed(given), given);
  EXPECT_EQ(changed({{"cache_dir", "/tmp/grids"}}), (Values{{"cache_dir", "/tmp/grids"}}));
}

TEST(ChangedOptions, AreComparedWithTheChosenCoreAndPreset) {
  EXPECT_EQ(changed({{"filter", "kld"}}), (Values{{"filter", "kld"}}));
  EXPECT_EQ(changed({{"filter", "kld"}, {"recovery", "false"}}), (Values{{"filter", "kld"}}));
  EXPECT_EQ(changed({{"filter", "kld"}, {"recovery", "true"}}),
            (Values{{"filter", "kld"}, {"recovery", "true"}}));
  EXPECT_EQ(changed({{"preset", "seed"}, {"laser_max_beams", "30"}}), (Values{{"preset", "seed"}}));
}

TEST(NodeOptions, FramesHaveNoSlashAndAreThree) {
  NodeOptions options;
  options.odom_frame_id = "/odom";
  EXPECT_EQ(withPlainFrames(options).odom_frame_id, "odom");
  const auto complaint = [](const std::string& global, const std::string& odom,
                            const std::string& base) -> std::string {
    NodeOptions frames;
    frames.global_frame_id = global;
    frames.odom_frame_id = odom;
    frames.base_frame_id = base;
    try {
      withPlainFrames(frames);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(complaint("/map", "odom", "base"), "none");
  EXPECT_EQ(complaint("odom", "/odom", "base"),
            "option 'odom_frame_id': got '/odom', expected another than global_frame_id");
  EXPECT_EQ(complaint("map", "odom", "map"),
            "option 'base_frame_id': got 'map', expected another than global_frame_id");
  EXPECT_EQ(complaint("map", "/", "base"),
            "option 'odom_frame_id': got '/', expected the name of a frame");
}

}  // namespace
}  // namespace adaptive_localization
