// SPDX-License-Identifier: BSD-3-Clause
// Someone else's filter in a library of their own works as the built-in ones do.
#include <gmock/gmock.h>

#include <stdexcept>

#include "adaptive_localization/localizer/localizer.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

Parameters withPlugin() {
  Parameters parameters;
  parameters.set("plugins", OptionValue{std::string(DEAD_RECKONING_PLUGIN)});
  parameters.set("filter", OptionValue{std::string("dead_reckoning")});
  return parameters;
}

TEST(Plugin, AddsItsFilterToTheRegistry) {
  Registries registries = builtins();
  registries.loadLibrary(DEAD_RECKONING_PLUGIN);
  EXPECT_THAT(registries.filters.names(), Contains("dead_reckoning"));
  EXPECT_THAT(registries.filters.names(), Contains("mcl"));
  EXPECT_EQ(registries.filters.find("dead_reckoning").options.at(0).key, "dead_reckoning_scale");
  EXPECT_THROW(registries.loadLibrary(DEAD_RECKONING_PLUGIN),
               std::invalid_argument);  // the name is taken
}

std::string complaintAbout(const std::string& library) {
  Registries registries;
  try {
    registries.loadLibrary(library);
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(registries.filters.names(), IsEmpty()) << "half a library was added";
    return error.what();
  }
  return "no complaint";
}

/// They used to end the process.
TEST(Plugin, IsRefusedByNameIfItsEntryPointIsNoFunctionOrThrowsAnything) {
  for (const char* library : {BROKEN_PLUGIN_1, BROKEN_PLUGIN_2}) {
    EXPECT_THAT(complaintAbout(library), HasSubstr(library));
  }
}

TEST(Plugin, IsRefusedIfItIsOfAnOlderVersion) {
  EXPECT_THAT(complaintAbout(BROKEN_PLUGIN_4),
              AllOf(HasSubstr(BROKEN_PLUGIN_4), HasSubstr("adaptive_localization_register_v2"),
                    HasSubstr("adaptive_localization_register_filters_v1: it was written for an "
                              "older version")));
}

TEST(Plugin, IsNotBelievedThatTheRobotIsAtNoPlace) {
  Parameters parameters;
  parameters.set("plugins", OptionValue{std::string(BROKEN_PLUGIN_3)});
  parameters.set("filter", OptionValue{std::string("nowhere")});
  Localizer localizer(parameters, asymmetricWorld());
  localizer.reset(Gaussian2{{1.0, 1.0, 0.0}, Eigen::Matrix3d::Identity()});
  const Observations seen = ToyLaser{}.observe(asymmetricWorld(), {1.0, 1.0, 0.0});
  EXPECT_THROW(localizer.update({}, seen), std::runtime_error);
}

TEST(Plugin, RunsInTheLocalizer) {
  Localizer localizer(withPlugin(), asymmetricWorld());
  EXPECT_THAT(localizer.unknownKeys(), IsEmpty());
  localizer.reset(Gaussian2{{1.0, 1.0, kPi / 2}, Eigen::Matrix3d::Zero()});
  const Observations seen = ToyLaser{}.observe(asymmetricWorld(), {1.0, 1.0, kPi / 2});
  localizer.update({5.0, 5.0, 0.0}, seen);
  const Localization answer = localizer.update({5.5, 5.0, 0.0}, seen);
  EXPECT_THAT(answer.T_map_base, PoseNear(Pose2{1.0, 1.5, kPi / 2}, 1e-9, 1e-9));
}

TEST(Plugin, TakesOverTheBeliefAndGivesItBackWhileTheRobotDrives) {
  const auto map = asymmetricWorld();
  Parameters other = withPlugin();
  other.set("filter", OptionValue{std::string("mcl")});
  other.set("laser_sigma_hit", OptionValue{0.1});
  Localizer localizer(other, map);
  const Gaussian2 start{{1.0, 1.0, 0.0}, Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal()};
  localizer.reset(start);
  const auto drive = [&](double x) {
    const Pose2 T_odom_base{x, 0.0, 0.0};
    return localizer.update(T_odom_base, ToyLaser{61}.observe(map, start.mean * T_odom_base));
  };
  for (int i = 0; i < 5; ++i) drive(0.2 * i);
  for (const Parameters& next : {withPlugin(), other, withPlugin()}) {
    const double x = drive(0.8).T_map_base.x;
    localizer.configure(next);
    EXPECT_NEAR(drive(0.8).T_map_base.x, x, 1e-9);
    EXPECT_THAT(drive(1.0).T_map_base, PoseNear(Pose2{2.0, 1.0, 0.0}, 0.1, 0.05));
    EXPECT_THAT(drive(0.8).T_map_base, PoseNear(Pose2{1.8, 1.0, 0.0}, 0.1, 0.05));
  }
}

TEST(Plugin, ShowsItsOptionsWhicheverFilterRuns) {
  Parameters parameters = withPlugin();
  parameters.set("filter", OptionValue{std::string("mcl")});
  parameters.set("dead_reckoning_scale", OptionValue{2});
  const Localizer localizer(parameters, asymmetricWorld());
  for (const auto& row : localizer.allOptions()) {
    if (row.key != "dead_reckoning_scale") continue;
    EXPECT_EQ(row.value, OptionValue{2.0});
    return;
  }
  FAIL() << "no option of the plug-in";
}

TEST(Plugin, HasOptionsAndPresets) {
  const auto travelled = [](const Parameters& parameters) {
    Localizer localizer(parameters, asymmetricWorld());
    localizer.reset(Gaussian2{});
    localizer.update({}, Observations{});
    return localizer.update({1.0, 0.0, 0.0}, Observations{}).T_map_base.x;
  };
  Parameters parameters = withPlugin();
  EXPECT_DOUBLE_EQ(travelled(parameters), 1.0);
  parameters.set("preset", OptionValue{std::string("seed")});
  EXPECT_DOUBLE_EQ(travelled(parameters), 2.0);
  parameters.set("dead_reckoning_scale", OptionValue{1.5});
  EXPECT_DOUBLE_EQ(travelled(parameters), 1.5);
  parameters.set("dead_reckoning_scale", OptionValue{3.0});
  EXPECT_THROW(travelled(parameters), std::invalid_argument);
}

TEST(Plugin, IsNamedWhenItIsMissing) {
  Parameters parameters = withPlugin();
  parameters.set("plugins", OptionValue{std::string(DEAD_RECKONING_PLUGIN) + ":/nowhere/lib.so"});
  try {
    Localizer(parameters, asymmetricWorld());
    FAIL() << "loaded a library that does not exist";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/lib.so"));
  }
}

}  // namespace
}  // namespace adaptive_localization
