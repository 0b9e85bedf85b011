// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/filters/registries.hpp"

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

#include "adaptive_localization/filters/builtins.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

template <class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

FilterContext context() {
  return {builtins(), asymmetricWorld()};
}

TEST(Builtins, AreThere) {
  for (const char* name : {"mcl", "kld", "amcl"}) {
    EXPECT_THAT(builtins().filters.names(), Contains(name));
    EXPECT_EQ(builtins().filters.find(name).name, name);
    EXPECT_FALSE(builtins().filters.find(name).sentence.empty());
  }
}

TEST(Registries, ListTheKnownNamesWhenOneIsUnknown) {
  EXPECT_THAT(complaint([&] { builtins().filters.find("amlc"); }),
              AllOf(HasSubstr("option 'filter': got 'amlc', expected one of amcl, "),
                    HasSubstr(", kld, "), HasSubstr(", mcl, ")));
}

TEST(Builtins, MakeNoFilterOfAModelThatNobodyKnows) {
  FilterContext given = context();
  given.parameters.set("laser_model_type", OptionValue(std::string("radar")));
  EXPECT_EQ(complaint([&] { builtins().filters.make("mcl", given); }),
            "option 'laser_model_type': got 'radar', expected one of beam, inverse_l1, "
            "likelihood_field, likelihood_field_cubed, likelihood_field_prob");
  given.parameters.set("odom_model_type", OptionValue(std::string("legs")));
  EXPECT_EQ(complaint([&] { builtins().filters.make("ekf_icp", given); }),
            "option 'odom_model_type': got 'legs', expected one of diff, diff-corrected, omni, "
            "omni-corrected");
}

TEST(Builtins, NeedAPlanToCastRaysOverItsWalls) {
  FilterContext given = context();
  given.parameters.set("swarm_ranges", OptionValue(std::string("lines")));
  for (const char* swarm : {"pso", "ba", "lbba"}) {
    EXPECT_EQ(complaint([&] { builtins().filters.make(swarm, given); }),
              "option 'line_map': got '', expected a floor plan, as swarm_ranges is 'lines'");
  }
}

/// Sizes with which one update takes seconds would leave the robot without a pose.
TEST(Builtins, RefuseSizesThatStallAndNameTheirPrice) {
  const auto make = [&](const std::string& name, int particles, int beams, const char* model) {
    FilterContext with = context();
    with.parameters.set("max_particles", OptionValue(particles));
    with.parameters.set("laser_max_beams", OptionValue(beams));
    with.parameters.set("laser_model_type", OptionValue(std::string(model)));
    return complaint([&] { builtins().filters.make(name, with); });
  };
  for (const char* name : {"mcl", "kld", "amcl", "samcl", "sa_kld"}) {
    EXPECT_EQ(make(name, 100000, 720, "likelihood_field"), "no complaint") << name;
    EXPECT_EQ(make(name, 50000, 180, "beam"), "no complaint") << name;
    EXPECT_THAT(make(name, 1000000, 10000, "likelihood_field"),
                AllOf(HasSubstr("'max_particles'"), HasSubstr("1000000"), HasSubstr("10000"),
                      HasSubstr("look-ups per update, expected at most 5e+09")));
    EXPECT_THAT(make(name, 100000, 720, "beam"), HasSubstr("laser_model_type beam")) << name;
  }
  EXPECT_THAT(make("mcl", 10000000, 30, "likelihood_field"), HasSubstr("in [1, 1000000]"));
}

TEST(Registries, NameALibraryThatCannotBeLoaded) {
  Registries registries;
  EXPECT_THAT(complaint([&] { registries.loadLibrary("/nowhere/lib.so"); }),
              HasSubstr("/nowhere/lib.so"));
  EXPECT_THAT(complaint([&] { registries.loadLibrary("libm.so.6"); }),
              AllOf(HasSubstr("libm.so.6"), HasSubstr("adaptive_localization_register_v2")));
}

/// Every built-in filter reads exactly the options that it lists, and its presets are of those.
TEST(Builtins, ReadTheOptionsTheyList) {
  for (const auto& name : builtins().filters.names()) {
    const FilterDescription& filter = builtins().filters.find(name);
    FilterContext given = context();
    std::set<std::string> keys;
    for (const auto& option : optionsOf(filter, builtins())) {
      EXPECT_TRUE(keys.insert(option.key).second) << name << " lists " << option.key << " twice";
      EXPECT_FALSE(option.sentence.empty()) << option.key;
      given.parameters.set(option.key, option.value);
    }
    filter.make(given);
    EXPECT_THAT(given.parameters.unknownKeys(), testing::IsEmpty()) << name;
  }
}

std::vector<std::string> keysOf(const std::vector<OptionDescription>& options) {
  std::vector<std::string> keys;
  for (const auto& option : options) keys.push_back(option.key);
  return keys;
}

TEST(OptionsOf, AreTheFiltersAndThoseOfEachModelThatItCanBeMadeOf) {
  Registries registries;
  const auto option = [](const std::string& key) {
    return OptionDescription{key, OptionValue{std::string()}, {}, {}, "", ""};
  };
  registries.motions.add({"crawl", "", [](const Parameters&) { return nullptr; }, {option("a")}});
  registries.motions.add(
      {"jump", "", [](const Parameters&) { return nullptr; }, {option("b"), option("a")}});
  const FilterDescription filter{"mine",
                                 "",
                                 [](const FilterContext&) { return nullptr; },
                                 {option("x"), option("odom_model_type"), option("y")},
                                 {},
                                 {}};
  const auto options = optionsOf(filter, registries);
  EXPECT_THAT(keysOf(options), ElementsAre("x", "odom_model_type", "a", "b", "y"));
  EXPECT_THAT(options[1].choices, ElementsAre("crawl", "jump"));
  registries.filters.add(filter);
  registries.filters.add({"z", "", filter.make, {option("z"), option("y")}, {}, {}});
  EXPECT_THAT(keysOf(optionsOfAll(registries)),
              ElementsAre("x", "odom_model_type", "a", "b", "y", "z"));
}

TEST(Builtins, HavePresetsThatMakeFilters) {
  for (const auto& name : builtins().filters.names()) {
    const FilterDescription& filter = builtins().filters.find(name);
    for (const auto& preset : filter.presetNames()) {
      FilterContext given = context();
      for (const auto& [key, value] : filter.preset(preset)) given.parameters.set(key, value);
      EXPECT_NE(filter.make(given), nullptr) << name;
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
