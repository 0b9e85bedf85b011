// SPDX-License-Identifier: BSD-3-Clause
// Someone else's models in a library of their own work as the built-in ones do.
#include <gmock/gmock.h>

#include <stdexcept>

#include "adaptive_localization/localizer/localizer.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_parameters.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

OptionValue text(const char* value) {
  return std::string(value);
}

Parameters withModels(const Values& more = {}) {
  Values values{{"plugins", text(FOREIGN_MODELS_PLUGIN)},
                {"odom_model_type", text("skid_steer")},
                {"laser_model_type", text("inliers")},
                {"refine", false}};
  for (const auto& [key, value] : more) values[key] = value;
  return parametersWith(values);
}

Gaussian2 at(const Pose2& mean, double deviation) {
  return {mean, deviation * deviation * Eigen::Matrix3d::Identity()};
}

const Pose2 kHere{1.0, 1.0, 0.0};

Observations seen() {
  return ToyLaser{31}.observe(asymmetricWorld(), kHere);
}

std::string complaint(const Parameters& parameters) {
  try {
    Localizer(parameters, asymmetricWorld());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

/// The heading after odometry turned by 0.2 rad.
double turned(Localizer& localizer) {
  localizer.reset(at(kHere, 0.0));
  localizer.update({}, Observations{});
  return localizer.update({0.0, 0.0, 0.2}, Observations{}).T_map_base.theta;
}

TEST(PluginModels, MoveTheRobot) {
  Localizer localizer(withModels(), asymmetricWorld());
  EXPECT_THAT(localizer.unknownKeys(), IsEmpty());
  EXPECT_NEAR(turned(localizer), 0.2, 1e-9);  // the built-in models' noise is not there
  localizer.configure(withModels({{"skid_steer_gain", 1.5}}));
  EXPECT_NEAR(turned(localizer), 0.3, 1e-9);
}

TEST(PluginModels, WeighParticles) {
  const auto differenceOfWeights = [](double weight) {
    Localizer localizer(withModels({{"inlier_weight", weight}}), asymmetricWorld());
    localizer.reset(at(kHere, 0.1));
    localizer.update({}, seen());
    const Eigen::ArrayXd& log_weight = localizer.hypotheses().log_weight;
    return log_weight.maxCoeff() - log_weight.minCoeff();
  };
  EXPECT_NEAR(differenceOfWeights(0.0), 0.0, 1e-12);
  EXPECT_NEAR(differenceOfWeights(0.5), 0.5, 0.3);
}

TEST(PluginModels, FindTheRobot) {
  Localizer localizer(withModels({{"refine", true}, {"skid_steer_noise", 0.02}}),
                      asymmetricWorld());
  localizer.reset(at(kHere * Pose2{0.1, 0.1, 0.05}, 0.1));
  Localization answer;
  for (int i = 0; i < 10; ++i) {
    localizer.requestUpdate();
    answer = localizer.update({}, seen());
  }
  EXPECT_THAT(answer.T_map_base, PoseNear(kHere, 0.1, 0.05));
}

TEST(PluginModels, AreAnotherSense) {
  Localizer localizer(withModels({{"gate_x", 1.0}}), asymmetricWorld());
  localizer.reset(at({1.0, 1.0, 0.0}, 0.2));
  localizer.update({}, Observations{});
  const Particles& all = localizer.hypotheses();
  const Eigen::ArrayXd weights = all.log_weight.exp();
  EXPECT_LT((all.x > 1.0).select(weights, 0.0).sum(), 1e-6 * weights.sum());
}

TEST(PluginModels, SayWhoSurvives) {
  Localizer localizer(
      withModels({{"resampling_scheme", text("heaviest")}, {"selective_resampling", false}}),
      asymmetricWorld());
  localizer.reset(at(kHere, 0.1));
  localizer.update({}, seen());
  const Particles& all = localizer.hypotheses();
  EXPECT_EQ(all.size(), 1000);
  EXPECT_EQ(all.x.maxCoeff(), all.x.minCoeff());
}

TEST(PluginModels, HaveOptionsThatAreCheckedAndListed) {
  EXPECT_THAT(complaint(withModels({{"skid_steer_gain", 3.0}})),
              HasSubstr("option 'skid_steer_gain': got '3', expected a number in [0.5, 2]"));
  EXPECT_THAT(complaint(withModels({{"inlier_distance", 0.0}})), HasSubstr("'inlier_distance'"));
  const Localizer localizer(withModels({{"inlier_weight", 3}}), asymmetricWorld());
  for (const auto& rows : {localizer.effectiveOptions(), localizer.allOptions()}) {
    std::map<std::string, OptionDescription> options;
    for (const auto& row : rows) options[row.key] = row;
    EXPECT_EQ(options["skid_steer_gain"].value, OptionValue{1.0});
    EXPECT_EQ(options["inlier_weight"].value, OptionValue{3.0});
    EXPECT_EQ(options["gate_x"].value, OptionValue{100.0});
    EXPECT_THAT(options["odom_model_type"].choices, Contains("skid_steer"));
    EXPECT_THAT(options["laser_model_type"].choices, AllOf(Contains("inliers"), Contains("beam")));
    EXPECT_THAT(options["resampling_scheme"].choices, Contains("heaviest"));
  }
}

/// As other cores' options are.
TEST(PluginModels, HaveOptionsThatAreKnownWhicheverModelIsChosen) {
  const auto others = withModels({{"odom_model_type", text("diff")},
                                  {"laser_model_type", text("beam")},
                                  {"skid_steer_gain", 1.5},
                                  {"inlier_weight", 3.0}});
  EXPECT_THAT(Localizer(others, asymmetricWorld()).unknownKeys(), IsEmpty());
}

TEST(PluginModels, AreNamedAmongTheKnownOnes) {
  EXPECT_EQ(complaint(withModels({{"laser_model_type", text("radar")}})),
            "option 'laser_model_type': got 'radar', expected one of beam, inliers, inverse_l1, "
            "likelihood_field, likelihood_field_cubed, likelihood_field_prob");
  EXPECT_THAT(complaint(withModels({{"odom_model_type", text("legs")}})),
              HasSubstr("omni-corrected, skid_steer"));
  EXPECT_THAT(complaint(withModels({{"resampling_scheme", text("fair")}})),
              HasSubstr("heaviest, multinomial"));
  EXPECT_THAT(complaint(withModels({{"plugins", text("")}})),
              HasSubstr("got 'inliers', expected one of beam, inverse_l1"));
}

TEST(PluginModels, ServeCoresThatMatchScansAndSwarmsToo) {
  for (const char* filter : {"ekf_icp", "pso", "sa_kld"}) {
    Localizer localizer(withModels({{"filter", text(filter)}}), asymmetricWorld());
    localizer.reset(at(kHere, 0.02));
    EXPECT_THAT(localizer.update({}, seen()).T_map_base, PoseNear(kHere, 0.1, 0.05)) << filter;
    EXPECT_THAT(complaint(withModels({{"filter", text(filter)}, {"skid_steer_gain", 0.0}})),
                HasSubstr("'skid_steer_gain'"))
        << filter;
  }
}

}  // namespace
}  // namespace adaptive_localization
