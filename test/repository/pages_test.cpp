// SPDX-License-Identifier: BSD-3-Clause
// What README.md and the pages in doc/ name exists: links, files, options, cores, launch arguments.
#include <glob.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "adaptive_localization/filters/builtins.hpp"

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::SizeIs;

const fs::path kRoot = SOURCE_DIR;

std::string contentsOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> linesOf(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// README.md and all pages in doc/, as paths below the repository's root.
std::vector<std::string> pages() {
  std::vector<std::string> all{"README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "doc")) {
    if (entry.path().extension() == ".md") all.push_back(fs::relative(entry, kRoot).string());
  }
  std::sort(all.begin(), all.end());
  return all;
}

struct Line {
  std::string text;
  bool is_code{false};
};

/// The lines of a page; those in fences or indented by four spaces are code.
std::vector<Line> markdown(const fs::path& file) {
  std::vector<Line> lines;
  bool in_fence = false;
  for (const auto& text : linesOf(file)) {
    const bool is_fence = text.rfind("```", 0) == 0;
    in_fence = in_fence != is_fence;
    lines.push_back({text, in_fence || is_fence || text.rfind("    ", 0) == 0});
  }
  return lines;
}

/// The anchor that a heading has on GitHub.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading.substr(heading.find_first_not_of("# "))) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') {
      anchor += '-';
    } else if (std::isalnum(byte) || c == '-' || c == '_' || byte >= 0x80) {
      anchor += static_cast<char>(std::tolower(byte));
    }
  }
  return anchor;
}

std::set<std::string> anchorsOf(const fs::path& page) {
  std::set<std::string> anchors;
  for (const auto& line : markdown(page)) {
    if (!line.is_code && line.text.rfind('#', 0) == 0) anchors.insert(anchorOf(line.text));
  }
  return anchors;
}

using Check = std::function<void(const std::string& page, const std::string& found)>;

/// Calls check for the first group of each match in each line; returns how many there are.
int forEachMatch(const std::string& pattern, const Check& check, bool with_code = true) {
  const std::regex regex(pattern);
  int count = 0;
  for (const auto& page : pages()) {
    for (const auto& line : markdown(kRoot / page)) {
      if (line.is_code && !with_code) continue;
      const std::string& text = line.text;
      for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
        check(page, (*it)[1]);
        ++count;
      }
    }
  }
  return count;
}

/// Links and pictures outside of code, as they are written.
int forEachLink(const Check& check) {
  return forEachMatch(R"(\]\(([^)\s]+)\))", check, false);
}

bool isOnTheWeb(const std::string& link) {
  return link.rfind("http", 0) == 0;
}

/// Whether there is a file of this name; * stands for anything.
bool isThere(const fs::path& file) {
  glob_t found{};
  const bool is_there = glob(file.c_str(), 0, nullptr, &found) == 0;
  globfree(&found);
  return is_there;
}

/// The options that there are; documents_test compares their tables with the program.
std::set<std::string> options() {
  std::set<std::string> keys;
  const std::regex row("^\\| `([a-z0-9_]+)` \\| [^|]* \\| [^|]* \\| .* \\|$");
  std::smatch match;
  for (const auto& line : linesOf(kRoot / "doc/options.md")) {
    if (std::regex_match(line, match, row)) keys.insert(match[1]);
  }
  return keys;
}

/// All sources, and the names of the files that describe experiments and worlds.
std::string sources() {
  std::string text;
  for (const auto* folder :
       {"src", "include", "launch", "scripts", "config", "maps", "test/bench"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (!entry.is_regular_file()) continue;
      text += entry.path().stem().string() + "\n";
      const auto kind = entry.path().extension();
      if (kind != ".pgm" && kind != ".png") text += contentsOf(entry.path()) + "\n";
    }
  }
  return text;
}

/// The words of C, Python, YAML and shell in a text.
std::set<std::string> wordsOf(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + "\n") {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
      word += c;
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  }
  return words;
}

}  // namespace

TEST(Pages, ReadmeIsAFirstPage) {
  EXPECT_THAT(linesOf(kRoot / "README.md"), SizeIs(testing::Le(250U)));
}

TEST(Pages, AllAreListed) {
  std::set<std::string> from_readme, from_index;
  forEachLink([&](const std::string& page, const std::string& link) {
    if (page == "README.md") from_readme.insert(link);
    if (page == "doc/README.md") from_index.insert("doc/" + link);
  });
  for (const auto& page : pages()) {
    if (page == "README.md" || page == "doc/README.md") continue;
    EXPECT_THAT(from_readme, Contains(page)) << "README.md";
    EXPECT_THAT(from_index, Contains(page)) << "doc/README.md";
  }
}

TEST(Pages, CodeEnds) {
  for (const auto& page : pages()) {
    EXPECT_FALSE(markdown(kRoot / page).back().is_code) << page;
  }
}

TEST(Pages, LinksLeadSomewhere) {
  const int count = forEachLink([](const std::string& page, const std::string& link) {
    if (isOnTheWeb(link)) return;
    const std::string file = link.substr(0, link.find('#'));
    const fs::path target =
        file.empty() ? kRoot / page : kRoot / fs::path(page).parent_path() / file;
    EXPECT_TRUE(fs::exists(target)) << page << " links to " << link;
    if (link.find('#') == std::string::npos || !fs::exists(target)) return;
    EXPECT_THAT(anchorsOf(target), Contains(link.substr(link.find('#') + 1))) << page;
  });
  EXPECT_GT(count, 50);
}

TEST(Pages, FilesExist) {
  const int count = forEachMatch(
      R"((?:^|[^\w./-])((?:scripts|config|doc|launch|maps|src|include|test)/[\w./*-]*[\w*]))",
      [](const std::string& page, const std::string& file) {
        EXPECT_TRUE(isThere(kRoot / file)) << page << " names " << file;
      });
  EXPECT_GT(count, 100);
}

TEST(Pages, SourceFilesExist) {
  const int count = forEachMatch(R"((?:^|[^\w./-])([\w.-]+/[\w./-]*\.[hc]pp))",
                                 [](const std::string& page, const std::string& file) {
                                   const bool is_there =
                                       isThere(kRoot / file) || isThere(kRoot / "src" / file) ||
                                       isThere(kRoot / "include" / file) ||
                                       isThere(kRoot / "include/adaptive_localization" / file);
                                   EXPECT_TRUE(is_there) << page << " names " << file;
                                 });
  EXPECT_GT(count, 10);
}

TEST(Pages, OptionsThatAreSetExist) {
  const std::set<std::string> known = options();
  ASSERT_GT(known.size(), 100U);
  // keys of world files, experiments and the simulator
  const std::set<std::string> of_others{"base", "lasers", "map", "reflector"};
  const auto check = [&](const std::string& page, const std::string& key) {
    EXPECT_TRUE(known.count(key) + of_others.count(key)) << page << " sets " << key;
  };
  EXPECT_GT(forEachMatch("`([a-z0-9_]+): [^`]+`", check), 20);
  int count = forEachMatch(R"(--set ([a-z0-9_]+)=)", check);
  count += forEachMatch(R"(--set [a-z0-9_]+=\S+ ([a-z0-9_]+)=)", check);
  EXPECT_GT(count, 4);
}

TEST(Pages, CoresThatAreChosenExist) {
  const auto names = builtins().filters.names();
  const int count = forEachMatch(R"((?:--filter |filter:=)([a-z0-9_]+))",
                                 [&](const std::string& page, const std::string& core) {
                                   EXPECT_THAT(names, Contains(core)) << page;
                                 });
  EXPECT_GT(count, 10);
}

TEST(Pages, ReadmeNamesEveryCore) {
  const std::string readme = contentsOf(kRoot / "README.md");
  for (const auto& core : builtins().filters.names()) {
    EXPECT_THAT(readme, HasSubstr("`" + core + "`"));
  }
}

TEST(Pages, LaunchFilesHaveTheArguments) {
  const int count = forEachMatch("(roslaunch.*:=.*)", [](const std::string& page,
                                                         const std::string& command) {
    std::smatch match;
    if (!std::regex_search(command, match, std::regex(R"(([a-z0-9]+\.launch))"))) return;
    const std::string launch = contentsOf(kRoot / "launch" / match[1].str());
    const std::regex argument(R"(([a-z0-9_]+):=)");
    for (std::sregex_iterator it(command.begin(), command.end(), argument), end; it != end; ++it) {
      EXPECT_THAT(launch, HasSubstr("<arg name=\"" + (*it)[1].str() + "\" default="))
          << page << ": " << command;
    }
  });
  EXPECT_GT(count, 4);
}

TEST(Pages, NamesInCodeAreThoseOfTheSources) {
  const std::set<std::string> known = wordsOf(sources());
  // a command of catkin's, and what the node makes of std_ and an axis
  const std::set<std::string> others{"catkin_make", "std_x", "std_y", "std_yaw"};
  const int count = forEachMatch(
      "`[~/]?([a-z][a-z0-9]*_[a-z0-9_]*)`", [&](const std::string& page, const std::string& name) {
        EXPECT_TRUE(known.count(name) + others.count(name)) << page << " names " << name;
      });
  EXPECT_GT(count, 200);
}

}  // namespace adaptive_localization
