// SPDX-License-Identifier: BSD-3-Clause
#include "localizer/former_options.hpp"

#include <gmock/gmock.h>

#include "adaptive_localization/localizer/localizer.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Parameters with(const std::string& key, double value) {
  Parameters parameters;
  parameters.set(key, OptionValue{value});
  return parameters;
}

TEST(FormerOptions, AreRefusedWithTheNewName) {
  EXPECT_THAT([] { refuseFormerOptions(with("ekf_gate", 9.0)); },
              ThrowsMessage<std::invalid_argument>(
                  HasSubstr("option 'ekf_gate': got 9, but this option was removed: it is "
                            "'ekf_gate_probability' now")));
  EXPECT_THAT([] { refuseFormerOptions(with("match_keep", 0.5)); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("'match_keep'")));
}

TEST(FormerOptions, AreNoneOfTheOptionsThatThereAre) {
  const Localizer localizer(Parameters{}, asymmetricWorld());
  for (const auto& option : localizer.allOptions()) {
    EXPECT_NO_THROW(refuseFormerOptions(with(option.key, 1.0))) << option.key;
  }
}

TEST(FormerOptions, AreRefusedByALocalizer) {
  EXPECT_THAT([] { Localizer(with("markov_cloud", 100.0), asymmetricWorld()); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("'cloud_particles'")));
}

}  // namespace
}  // namespace adaptive_localization
