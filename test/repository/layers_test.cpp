// SPDX-License-Identifier: BSD-3-Clause
// Who may include whom. The README draws it; this reads the sources.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

struct Include {
  std::string layer;  // folder of the including file; "top" for those in none
  std::string file;
  std::string header;
};

/// sim/world.hpp of adaptive_localization/sim/world.hpp or src/sim/world.hpp -> sim.
std::string layerOf(std::string path) {
  for (const std::string root : {"include/", "src/", "adaptive_localization/", "../"}) {
    if (path.rfind(root, 0) == 0) path = path.substr(root.size());
  }
  const auto slash = path.find('/');
  return slash == std::string::npos ? "top" : path.substr(0, slash);
}

std::vector<Include> readIncludes() {
  const std::regex pattern(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  std::vector<Include> found;
  for (const std::string folder : {"include", "src"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file()) continue;
      const std::string file = fs::relative(entry.path(), SOURCE_DIR).string();
      std::ifstream stream(entry.path());
      std::smatch match;
      for (std::string line; std::getline(stream, line);) {
        if (std::regex_search(line, match, pattern)) {
          found.push_back({layerOf(file), file, match[1]});
        }
      }
    }
  }
  return found;
}

const std::vector<Include>& includes() {
  static const std::vector<Include> all = readIncludes();
  return all;
}

std::string nameOf(const Include& include) {
  return include.file + " includes " + include.header;
}

bool isOurs(const std::string& header) {
  return header.rfind("adaptive_localization/", 0) == 0 || header.rfind("../", 0) == 0 ||
         header.rfind("filters/", 0) == 0;
}

}  // namespace

TEST(Layers, TheSourcesAreRead) {
  EXPECT_THAT(includes(), Contains(Field(&Include::file, HasSubstr("particle_filter.cpp"))));
  EXPECT_EQ(layerOf("include/adaptive_localization/map/lattice.hpp"), "map");
  EXPECT_EQ(layerOf("adaptive_localization/pose2.hpp"), "top");
  EXPECT_EQ(layerOf("src/apps/replay.cpp"), "apps");
}

TEST(Layers, AFolderIncludesOnlyWhatIsBelowIt) {
  const std::map<std::string, std::set<std::string>> below{
      {"top", {"top", "map", "ser", "match", "filters"}},
      {"map", {"top", "map"}},
      {"motion", {"top", "map", "motion"}},
      {"observation", {"top", "map", "observation"}},
      {"particle", {"top", "map", "particle"}},
      {"ser", {"top", "map", "particle", "ser"}},
      {"swarm", {"top", "map", "ser", "swarm"}},
      {"match", {"top", "map", "match"}},
      {"filters",
       {"top", "map", "motion", "observation", "particle", "ser", "swarm", "match", "filters"}},
      {"sim", {"top", "map", "sim"}},
      {"bag", {"bag"}},
      {"eval", {"top", "map", "particle", "ser", "swarm", "match", "sim", "bag", "eval"}},
      {"ros", {"top", "map", "ser", "match", "sim", "bag", "ros"}},
      {"apps", {"top", "map", "ser", "sim", "eval", "ros"}}};
  std::vector<std::string> wrong;
  for (const auto& include : includes()) {
    const auto allowed = below.find(include.layer);
    ASSERT_NE(allowed, below.end()) << "no rule for the folder of " << include.file;
    if (isOurs(include.header) && !allowed->second.count(layerOf(include.header))) {
      wrong.push_back(nameOf(include));
    }
  }
  EXPECT_THAT(wrong, IsEmpty());
}

TEST(Layers, ModelsDoNotKnowWhoUsesThem) {
  const std::set<std::string> users{"adaptive_localization/localizer.hpp",
                                    "adaptive_localization/confidence.hpp",
                                    "adaptive_localization/filter_registry.hpp"};
  std::vector<std::string> wrong;
  for (const auto& include : includes()) {
    const bool is_model = include.layer == "map" || include.layer == "motion" ||
                          include.layer == "observation" || include.layer == "particle" ||
                          include.layer == "ser" || include.layer == "swarm" ||
                          include.layer == "match";
    if (is_model && users.count(include.header)) wrong.push_back(nameOf(include));
  }
  EXPECT_THAT(wrong, IsEmpty());
}

TEST(Layers, OnlyTheBorderKnowsRos) {
  const std::regex ros_header(R"re(^(ros|tf2?|tf2_\w+|rosbag|message_filters|\w+_(msgs|srvs))/)re");
  std::vector<std::string> wrong;
  for (const auto& include : includes()) {
    const bool is_border = include.layer == "ros" || include.layer == "apps" ||
                           include.layer == "bag" || include.file.rfind("src/eval/bag_log", 0) == 0;
    if (!is_border && std::regex_search(include.header, ros_header)) {
      wrong.push_back(nameOf(include));
    }
  }
  EXPECT_THAT(wrong, IsEmpty());
}

/// What roscpp calls must not throw: a function reaches it through ros/callbacks.hpp alone.
TEST(Layers, EveryCallbackIsGuarded) {
  const std::regex hands_over(
      R"re((\.|->)(subscribe|advertiseService|createTimer|createWallTimer)\b|tf2_ros::TransformListener)re");
  std::vector<std::string> wrong;
  bool guard_was_read = false;
  for (const std::string folder : {"src/ros", "src/apps"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_DIR) / folder)) {
      std::ifstream stream(entry.path());
      const bool is_guard = entry.path().filename() == "callbacks.hpp";
      for (std::string line; std::getline(stream, line);) {
        if (!std::regex_search(line, hands_over)) continue;
        guard_was_read = guard_was_read || is_guard;
        if (!is_guard) wrong.push_back(entry.path().filename().string() + ": " + line);
      }
    }
  }
  EXPECT_TRUE(guard_was_read);
  EXPECT_THAT(wrong, IsEmpty());
}

TEST(Layers, PublicHeadersNeedOnlyPublicHeaders) {
  const std::regex known(
      R"re(^(adaptive_localization/.*\.hpp|Eigen/\w+|boost/.*|nlohmann/.*|[a-z_]+)$)re");
  std::vector<std::string> wrong;
  for (const auto& include : includes()) {
    const bool is_public = include.file.rfind("include/", 0) == 0;
    if (is_public && !std::regex_match(include.header, known)) wrong.push_back(nameOf(include));
  }
  EXPECT_THAT(wrong, IsEmpty());
}

}  // namespace adaptive_localization
