// SPDX-License-Identifier: BSD-3-Clause
// What is generated from the options in the source is up to date; scripts/update_docs writes it.
#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <string>

#include "adaptive_localization/filters/builtins.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "core/audience.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;

constexpr auto kAdvice = "run scripts/update_docs";
constexpr auto kOptionsPage = "doc/options.md";

std::string outputOf(const std::string& arguments) {
  const std::string command = std::string(LIST_OPTIONS) + " " + arguments + " 2>&1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) {
    text += static_cast<char>(c);
  }
  return text;
}

std::string contentsOf(const std::string& file) {
  std::ifstream stream(std::string(SOURCE_DIR) + "/" + file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string fileOf(const std::string& core, const std::string& preset) {
  return "config/filters/" + core + (preset == "recommended" ? "" : "_" + preset) + ".yaml";
}

/// Calls check(core, preset) for all there are.
template <class Check>
void forEachPreset(const Check& check) {
  for (const auto& core : builtins().filters.names()) {
    for (const auto& preset : builtins().filters.find(core).presetNames()) check(core, preset);
  }
}

}  // namespace

TEST(Documents, OptionsPageHoldsTheTables) {
  const std::string tables = outputOf("");
  ASSERT_THAT(tables, HasSubstr("`laser_max_beams`"));
  const std::string page = contentsOf(kOptionsPage);
  EXPECT_NE(page.find("<!-- options -->\n" + tables + "<!-- end of options -->"), std::string::npos)
      << kAdvice;
}

TEST(Documents, OptionsPageHasEveryOption) {
  const auto cell =
      std::make_shared<const OccupancyGrid>(Lattice(1, 1, 1.0, {}), std::vector<std::int8_t>{0});
  const std::string page = contentsOf(kOptionsPage);
  const auto options = Localizer({}, cell).allOptions();
  EXPECT_GT(options.size(), 100U);
  for (const auto& option : options) {
    EXPECT_NE(page.find("| `" + option.key + "` |"), std::string::npos)
        << option.key << " is in no table of list_options";
  }
}

TEST(Documents, OptionsForUsersAreFew) {
  const std::string page = contentsOf(kOptionsPage);
  const auto begin = page.find("## Options for users"), end = page.find("## amcl's options");
  ASSERT_LT(begin, end);
  const std::string part = page.substr(begin, end - begin);
  const std::regex row("\n\\| `");
  const auto rows = std::distance(std::sregex_iterator(part.begin(), part.end(), row), {});
  EXPECT_GT(rows, 20);
  EXPECT_LE(rows, 50);
}

TEST(Documents, OptionsOfAmclAreKnownAsSuch) {
  Parameters stock;
  stock.load(std::string(SOURCE_DIR) + "/config/amcl.yaml");
  EXPECT_GT(stock.values().size(), 40U);
  for (const auto& [key, value] : stock.values()) {
    EXPECT_EQ(audienceOf(key), Audience::kAmcl) << key;
  }
}

TEST(Documents, OptionsPageHasTheValuesOfTheDefaultCore) {
  const auto cell =
      std::make_shared<const OccupancyGrid>(Lattice(1, 1, 1.0, {}), std::vector<std::int8_t>{0});
  const std::string page = contentsOf(kOptionsPage);
  for (const auto& option : Localizer({}, cell).effectiveOptions()) {
    if (!std::holds_alternative<bool>(option.value)) continue;
    EXPECT_NE(page.find("| `" + option.key + "` | " + toText(option.value) + " |"),
              std::string::npos)
        << option.key << ": " << kAdvice;
  }
}

TEST(Documents, ParameterFilesAreUpToDate) {
  forEachPreset([](const std::string& core, const std::string& preset) {
    EXPECT_EQ(contentsOf(fileOf(core, preset)), outputOf("--yaml " + core + " --preset " + preset))
        << fileOf(core, preset) << ": " << kAdvice;
  });
}

TEST(Documents, ParameterFilesGiveWhatThePresetGives) {
  const auto cell =
      std::make_shared<const OccupancyGrid>(Lattice(1, 1, 1.0, {}), std::vector<std::int8_t>{0});
  forEachPreset([&](const std::string& core, const std::string& preset) {
    Parameters named;
    named.set("filter", OptionValue{core});
    named.set("preset", OptionValue{preset});
    Parameters loaded;
    loaded.load(std::string(SOURCE_DIR) + "/" + fileOf(core, preset));
    const auto expected = Localizer(named, cell).effectiveOptions();
    const Localizer localizer(loaded, cell);
    const auto actual = localizer.effectiveOptions();
    EXPECT_TRUE(localizer.unknownKeys().empty());
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
      EXPECT_EQ(toText(actual[i].value), toText(expected[i].value)) << actual[i].key;
    }
  });
}

TEST(Documents, FieldsOfDynamicReconfigureAreUpToDate) {
  const std::string fields = outputOf("--cfg");
  EXPECT_THAT(fields, HasSubstr("gen.add(\"laser_max_beams\", int_t, 0,"));
  EXPECT_EQ(contentsOf("config/AdaptiveLocalization.cfg"), fields) << kAdvice;
}

TEST(Documents, ListOptionsRefusesWhatItDoesNotKnow) {
  EXPECT_THAT(outputOf("--preset seed"), testing::HasSubstr("--preset needs --yaml CORE"));
  EXPECT_THAT(outputOf("--cfg --yaml kld"), testing::HasSubstr("exclude each other"));
  EXPECT_THAT(outputOf("--yaml nosuch"), HasSubstr("'nosuch'"));
  EXPECT_THAT(outputOf("--yaml kld --preset nosuch"), HasSubstr("'nosuch'"));
  EXPECT_THAT(outputOf("--nosuch"), HasSubstr("usage:"));
}

}  // namespace adaptive_localization
