// SPDX-License-Identifier: BSD-3-Clause
// Who may include whom. doc/how_it_works.md draws it; this reads the sources.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
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

/// Folder by folder, from the ground up: who may be included by a folder stands before it.
const std::vector<std::pair<std::string, std::set<std::string>>>& rules() {
  static const std::vector<std::pair<std::string, std::set<std::string>>> all{
      {"core", {}},
      {"map", {"core"}},
      {"motion", {"core"}},
      {"observation", {"core", "map"}},
      {"particle", {"core", "map"}},
      {"match", {"core", "map", "observation", "particle"}},
      {"ser", {"core", "map", "particle"}},
      {"swarm", {"core", "map", "ser"}},
      {"filters", {"core", "map", "motion", "observation", "particle", "match", "ser", "swarm"}},
      {"localizer",
       {"core", "map", "motion", "observation", "particle", "match", "ser", "filters"}},
      {"sim", {"core", "map"}},
      {"bag", {"core", "map"}},
      {"vision", {"core"}},
      {"eval",
       {"core", "map", "particle", "match", "ser", "swarm", "filters", "localizer", "sim", "bag"}},
      {"ros",
       {"core", "map", "observation", "match", "ser", "filters", "localizer", "sim", "bag",
        "vision"}},
      {"rviz", {"core", "ros"}},
      {"apps", {"core", "map", "observation", "match", "ser", "localizer", "sim", "eval", "ros"}}};
  return all;
}

bool isOurs(const std::string& header) {
  const bool is_hpp = header.size() > 4 && header.substr(header.size() - 4) == ".hpp";
  if (!is_hpp || header.find('/') == std::string::npos) return false;  // or of the same folder
  const std::string layer = layerOf(header);
  return std::any_of(rules().begin(), rules().end(),
                     [&](const auto& rule) { return rule.first == layer; });
}

/// map/lattice of include/adaptive_localization/map/lattice.hpp or src/map/lattice.cpp.
std::string unitOf(const std::string& path) {
  fs::path unit = fs::path(path).lexically_normal().replace_extension();
  for (const std::string root : {"include", "src", "adaptive_localization"}) {
    if (*unit.begin() == root) unit = unit.lexically_relative(root);
  }
  return unit.generic_string();
}

using Graph = std::map<std::string, std::set<std::string>>;  // whom each unit includes

/// Of the units, a header and its source, that are ours. A header is looked for beside the file
/// that includes it, in src and among the public ones.
Graph unitGraph(const std::vector<Include>& all) {
  Graph graph;
  for (const auto& include : all) graph[unitOf(include.file)];
  for (const auto& include : all) {
    const std::string unit = unitOf(include.file);
    const fs::path beside = fs::path(include.file).parent_path() / include.header;
    for (const std::string& header : {beside.string(), include.header}) {
      const auto other = graph.find(unitOf(header));
      const bool is_found = other != graph.end();
      if (is_found && other->first != unit) graph[unit].insert(other->first);
      if (is_found) break;
    }
  }
  return graph;
}

/// Goes on from the last unit of a way that has no circle yet. A circle begins and ends with the
/// same unit; empty: there is none.
std::vector<std::string> circleFrom(const std::vector<std::string>& way, const Graph& graph,
                                    std::set<std::string>& done) {
  if (done.count(way.back())) return {};
  for (const std::string& other : graph.at(way.back())) {
    std::vector<std::string> longer = way;
    longer.push_back(other);
    const auto met = std::find(way.begin(), way.end(), other);
    if (met != way.end()) return {longer.begin() + (met - way.begin()), longer.end()};
    const auto circle = circleFrom(longer, graph, done);
    if (!circle.empty()) return circle;
  }
  done.insert(way.back());
  return {};
}

/// One circle, or none.
std::vector<std::string> findCircle(const Graph& graph) {
  std::set<std::string> done;
  for (const auto& entry : graph) {
    const auto circle = circleFrom({entry.first}, graph, done);
    if (!circle.empty()) return circle;
  }
  return {};
}

}  // namespace

TEST(Layers, TheSourcesAreRead) {
  EXPECT_THAT(includes(), Contains(Field(&Include::file, HasSubstr("particle_filter.cpp"))));
  EXPECT_EQ(layerOf("include/adaptive_localization/map/lattice.hpp"), "map");
  EXPECT_EQ(layerOf("adaptive_localization/core/pose2.hpp"), "core");
  EXPECT_EQ(layerOf("src/apps/replay.cpp"), "apps");
}

TEST(Layers, TheRulesHaveNoCircle) {
  std::set<std::string> below;
  for (const auto& [layer, allowed] : rules()) {
    for (const std::string& other : allowed) {
      EXPECT_TRUE(below.count(other))
          << layer << " may include " << other << ", which is not below";
    }
    below.insert(layer);
  }
}

TEST(Layers, ACircleOfUnitsIsFound) {
  EXPECT_EQ(unitOf("include/adaptive_localization/map/lattice.hpp"), "map/lattice");
  EXPECT_EQ(unitOf("src/apps/../ros/node_options.hpp"), "ros/node_options");
  const Graph graph = unitGraph({{"sim", "src/sim/a.hpp", "adaptive_localization/sim/b.hpp"},
                                 {"sim", "include/adaptive_localization/sim/b.hpp", "vector"},
                                 {"sim", "src/sim/b.cpp", "c.hpp"},
                                 {"bag", "src/bag/c.hpp", "../sim/a.hpp"},
                                 {"sim", "src/sim/c.cpp", "c.hpp"}});
  EXPECT_THAT(graph.at("sim/b"), testing::ElementsAre("sim/c"));
  EXPECT_THAT(graph.at("sim/c"), IsEmpty()) << "its own header";
  EXPECT_THAT(findCircle(graph), IsEmpty());
  const Graph circle{{"a", {"b"}}, {"b", {"c"}}, {"c", {"d", "b"}}, {"d", {}}};
  EXPECT_THAT(findCircle(circle), testing::ElementsAre("b", "c", "b"));
}

TEST(Layers, NoUnitIncludesWhatIncludesIt) {
  const Graph graph = unitGraph(includes());
  ASSERT_THAT(graph.at("apps/replay"), Contains("eval/replay_command"));
  ASSERT_THAT(graph.at("ros/localization_node"), Contains("ros/node_options"));
  std::string text;
  for (const auto& unit : findCircle(graph)) text += (text.empty() ? "" : " -> ") + unit;
  EXPECT_EQ(text, "") << "a circle of includes";
}

TEST(Layers, AFolderIncludesOnlyWhatIsBelowIt) {
  const std::map<std::string, std::set<std::string>> below(rules().begin(), rules().end());
  std::vector<std::string> wrong;
  for (const auto& include : includes()) {
    const auto allowed = below.find(include.layer);
    ASSERT_NE(allowed, below.end()) << "no rule for the folder of " << include.file;
    const std::string layer = layerOf(include.header);
    if (isOurs(include.header) && layer != include.layer && !allowed->second.count(layer)) {
      wrong.push_back(nameOf(include));
    }
  }
  EXPECT_THAT(wrong, IsEmpty());
}

TEST(Layers, OnlyTheBorderKnowsRos) {
  const std::regex ros_header(R"re(^(ros|tf2?|tf2_\w+|rosbag|message_filters|\w+_(msgs|srvs))/)re");
  std::vector<std::string> wrong;
  for (const auto& include : includes()) {
    const bool is_border = include.layer == "ros" || include.layer == "apps" ||
                           include.layer == "bag" || include.layer == "rviz" ||
                           include.file.rfind("src/eval/bag_log", 0) == 0;
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
  for (const std::string folder : {"src/ros", "src/rviz", "src/apps"}) {
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

/// What a program that localizes and a plug-in need, and no more.
TEST(Layers, PublicHeadersAreFewAndNeedOnlyPublicHeaders) {
  const std::regex known(R"re(^(adaptive_localization/.*\.hpp|Eigen/\w+|boost/.*|[a-z_]+)$)re");
  std::vector<std::string> wrong;
  std::set<std::string> headers;
  for (const auto& include : includes()) {
    if (include.file.rfind("include/", 0) != 0) continue;
    headers.insert(include.file);
    if (!std::regex_match(include.header, known)) wrong.push_back(nameOf(include));
  }
  EXPECT_THAT(wrong, IsEmpty());
  EXPECT_GT(headers.size(), 20U) << "the headers are read";
  EXPECT_LE(headers.size(), 50U);
}

}  // namespace adaptive_localization
