// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "adaptive_localization/localizer/localizer.hpp"
#include "support/toy_parameters.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string complaint(const Parameters& parameters,
                      const std::shared_ptr<const OccupancyGrid>& map = asymmetricWorld()) {
  try {
    Localizer(parameters, map);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

OptionValue effective(const Localizer& localizer, const std::string& key) {
  const auto rows = localizer.effectiveOptions();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.key == key; });
  return row == rows.end() ? OptionValue{std::string("none")} : row->value;
}

TEST(LocalizerOptions, AreRefusedByName) {
  EXPECT_THAT(complaint(parametersWith({{"filter", std::string("mlc")}})),
              AllOf(HasSubstr("'mlc'"), HasSubstr("amcl"), HasSubstr("mcl")));
  EXPECT_THAT(complaint(parametersWith({{"preset", std::string("best")}})),
              AllOf(HasSubstr("preset"), HasSubstr("recommended, seed")));
  EXPECT_THAT(
      complaint(parametersWith({{"filter", std::string("kld")}, {"preset", std::string("fp")}})),
      AllOf(HasSubstr("'fp'"), HasSubstr("recommended, seed: those of kld")));
  EXPECT_EQ(
      complaint(parametersWith({{"filter", std::string("mcl")}, {"preset", std::string("fp")}})),
      "no complaint");
  EXPECT_THAT(complaint(parametersWith({{"odom_alpha1", -1.0}})), HasSubstr("'odom_alpha1'"));
  EXPECT_THAT(complaint(parametersWith({{"seed", -1}})), HasSubstr("'seed'"));
  EXPECT_THAT(complaint(parametersWith(), toyWorld({"#?#"}, 0.1)), HasSubstr("no free cell"));
  EXPECT_THAT(complaint(parametersWith({{"filter", std::string("kld")}, {"min_particles", 2000}})),
              HasSubstr("min_particles"));
  EXPECT_THAT(complaint(parametersWith({{"laser_min_range", 5.0}, {"laser_max_range", 2.0}})),
              AllOf(HasSubstr("'laser_min_range': got '5'"), HasSubstr("laser_max_range")));
  EXPECT_THAT(complaint(parametersWith({{"reflector_intensity", 120.0}})),
              HasSubstr("'reflector_intensity': got '120' without a landmark_map"));
}

/// amcl's defaults are other ones: what is right there must not be refused for ours.
TEST(LocalizerOptions, ALimitOfParticlesThatNobodyGaveGivesWay) {
  const auto limits = [](const std::string& key, int value, const std::string& preset) {
    Parameters parameters;
    parameters.set("filter", OptionValue{std::string("kld")});
    parameters.set("preset", OptionValue{preset});
    parameters.set(key, OptionValue{value});
    const Localizer localizer(parameters, asymmetricWorld());
    return std::pair(std::get<int>(effective(localizer, "min_particles")),
                     std::get<int>(effective(localizer, "max_particles")));
  };
  for (const char* preset : {"recommended", "seed"}) {
    EXPECT_EQ(limits("max_particles", 30, preset), std::pair(30, 30)) << preset;
    EXPECT_EQ(limits("min_particles", 70000, preset), std::pair(70000, 70000)) << preset;
  }
  EXPECT_EQ(limits("max_particles", 3000, "recommended").second, 3000);
  EXPECT_GT(limits("max_particles", 3000, "recommended").first, 100) << "as ever";
}

TEST(LocalizerOptions, ThatNobodyKnowsAreListed) {
  const Localizer localizer(parametersWith({{"odom_alpha_1", 0.1}, {"recovery_alpha_slow", 0.1}}),
                            asymmetricWorld());
  EXPECT_THAT(localizer.unknownKeys(), ElementsAre("odom_alpha_1"));
}

TEST(LocalizerOptions, ComeFromThePresetUnlessGiven) {
  Parameters parameters;
  parameters.set("filter", OptionValue{std::string("mcl")});
  parameters.set("preset", OptionValue{std::string("seed")});
  parameters.set("odom_noise_theta", OptionValue{0.5});
  const Localizer localizer(parameters, asymmetricWorld());
  const auto seed = builtins().filters.find("mcl").seed;
  for (const auto& [key, value] : seed) {
    if (key == "odom_noise_theta") continue;
    EXPECT_EQ(effective(localizer, key), value) << key;
  }
  ASSERT_EQ(seed.count("odom_noise_theta"), 1u);
  EXPECT_EQ(effective(localizer, "odom_noise_theta"), OptionValue{0.5});
  EXPECT_EQ(OptionValue{localizer.options().update_min_d}, seed.at("update_min_d"));
  EXPECT_EQ(OptionValue{localizer.scanOptions().laser_max_beams}, seed.at("laser_max_beams"));
}

}  // namespace
}  // namespace adaptive_localization
