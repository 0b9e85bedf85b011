// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/node_link.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace adaptive_localization {

/// rviz.launch remaps the topics that its configuration names: a panel must not take one node for
/// another.
TEST(NodeLink, NamesThatThisProcessRemapsAreRefused) {
  const ros::M_string remappings{{"adaptive_localization/modes", "amcl/modes"}};
  ros::init(remappings, "node_link_test", ros::init_options::NoSigintHandler);
  EXPECT_FALSE(isRemapped("/amcl/modes"));
  EXPECT_NO_THROW(checkNotRemapped("/amcl/modes"));
  EXPECT_TRUE(isRemapped("/adaptive_localization/modes"));
  try {
    checkNotRemapped("/adaptive_localization/modes");
    ADD_FAILURE() << "was not refused";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("/adaptive_localization/modes remapped to /amcl/modes"));
  }
}

}  // namespace adaptive_localization
