// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/untuned.hpp"

#include <gmock/gmock.h>

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Parameters stock() {
  Parameters parameters;
  parameters.load(SOURCE_DIR "/config/amcl.yaml");
  return parameters;
}

TEST(Untuned, ParametersAreThoseWithAmclsUsualValues) {
  EXPECT_THAT(untunedKeys(stock()),
              AllOf(Contains("odom_alpha1"), Contains("laser_max_beams"), Contains("update_min_a"),
                    Contains("odom_model_type"), Not(Contains("base_frame_id")),
                    Not(Contains("initial_pose_x")), Not(Contains("laser_z_hit"))))
      << "frames and poses are the robot's, and laser_z_hit is as here";
  EXPECT_THAT(untunedKeys({}), IsEmpty());
}

TEST(Untuned, ParametersThatSomebodyTunedAreNotAmongThem) {
  Parameters parameters = stock();
  parameters.set("odom_alpha1", OptionValue{0.05});
  parameters.set("laser_max_beams", OptionValue{61});
  parameters.set("odom_model_type", OptionValue{std::string("omni")});
  EXPECT_THAT(untunedKeys(parameters),
              AllOf(Not(Contains("odom_alpha1")), Contains("odom_alpha2"),
                    Not(Contains("laser_max_beams")), Not(Contains("odom_model_type"))));
}

TEST(Untuned, NumbersMayBeWholeOrRounded) {
  Parameters parameters;
  parameters.set("laser_max_beams", OptionValue{30.0});
  parameters.set("update_min_a", OptionValue{0.5236});
  parameters.set("recovery_alpha_slow", OptionValue{0});
  EXPECT_EQ(untunedKeys(parameters).size(), 3U);
}

TEST(Untuned, ParametersAreNamedAndKeptUnlessAskedOtherwise) {
  const TunedParameters kept = tuned(stock());
  EXPECT_EQ(kept.parameters.values(), stock().values());
  EXPECT_THAT(kept.remark, AllOf(HasSubstr("odom_alpha1"), HasSubstr("ignore_untuned")));
  EXPECT_THAT(tuned({}).remark, IsEmpty());
}

TEST(Untuned, ParametersAreIgnoredWhereThatIsAskedFor) {
  Parameters given = stock();
  given.set("amcl_compatibility", OptionValue{std::string("ignore_untuned")});
  given.set("odom_alpha3", OptionValue{0.07});
  const TunedParameters left = tuned(given);
  EXPECT_FALSE(left.parameters.has("odom_alpha1"));
  EXPECT_TRUE(left.parameters.has("odom_alpha3"));
  EXPECT_TRUE(left.parameters.has("odom_frame_id"));
  EXPECT_THAT(left.remark,
              AllOf(HasSubstr("Ignored"), HasSubstr("odom_alpha1"), Not(HasSubstr("odom_alpha3"))));
}

}  // namespace
}  // namespace adaptive_localization
