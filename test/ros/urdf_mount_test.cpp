// SPDX-License-Identifier: BSD-3-Clause
#include "ros/urdf_mount.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

using ::testing::HasSubstr;

const char* const kRobot = R"(<robot name="r">
  <link name="base_footprint"/> <link name="base_link"/> <link name="plate"/> <link name="laser"/>
  <link name="wheel"/>
  <joint name="up" type="fixed">
    <parent link="base_footprint"/> <child link="base_link"/> <origin xyz="0 0 0.1"/>
  </joint>
  <joint name="top" type="fixed">
    <parent link="base_link"/> <child link="plate"/> <origin xyz="1 0 0.2" rpy="0 0 1.5707963268"/>
  </joint>
  <joint name="mount" type="fixed">
    <parent link="plate"/> <child link="laser"/> <origin xyz="0.5 0 0.1" rpy="3.1415926536 0 0"/>
  </joint>
  <joint name="axle" type="continuous">
    <parent link="base_link"/> <child link="wheel"/>
  </joint>
</robot>)";

std::string errorOf(const std::string& urdf, const std::string& base, const std::string& sensor) {
  try {
    mountFromUrdf(urdf, base, sensor);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(UrdfMount, FixedJointsAreChained) {
  const Eigen::Isometry3d mount = mountFromUrdf(kRobot, "base_link", "laser");
  EXPECT_TRUE(mount.translation().isApprox(Eigen::Vector3d(1.0, 0.5, 0.3), 1e-9));
  EXPECT_TRUE((mount.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-9));
  EXPECT_NEAR(mount.linear()(2, 2), -1.0, 1e-9);  // upside down
}

TEST(UrdfMount, AnyLinkAboveIsABase) {
  const Eigen::Isometry3d mount = mountFromUrdf(kRobot, "base_footprint", "laser");
  EXPECT_NEAR(mount.translation().z(), 0.4, 1e-9);
  EXPECT_TRUE(mountFromUrdf(kRobot, "laser", "laser").isApprox(Eigen::Isometry3d::Identity()));
}

TEST(UrdfMount, ErrorsSayWhatIsInTheWay) {
  EXPECT_THAT(errorOf("<robot", "base_link", "laser"), HasSubstr("no valid URDF"));
  EXPECT_THAT(errorOf(kRobot, "base_link", "lidar"), HasSubstr("no link 'lidar'"));
  EXPECT_THAT(errorOf(kRobot, "odom", "laser"), HasSubstr("'laser' is not mounted on 'odom'"));
  EXPECT_THAT(errorOf(kRobot, "base_link", "wheel"), HasSubstr("joint 'axle'"));
}

TEST(UrdfView, IsTheSensorsOfThatLink) {
  std::string urdf = kRobot;
  urdf.insert(urdf.rfind("</robot>"), R"(
    <sensor name="camera"><parent link="plate"/><origin xyz="0 0 0"/>
      <camera><image width="1" height="1" format="L8" hfov="1" near="0.1" far="9"/></camera></sensor>
    <sensor name="other"><parent link="plate"/><origin xyz="0 0 0"/>
      <ray><horizontal samples="9" resolution="1" min_angle="-3" max_angle="3"/></ray></sensor>
    <sensor name="lms"><parent link="laser"/><origin xyz="0 0 0"/>
      <ray><horizontal samples="9" resolution="1" min_angle="-1" max_angle="0.5"/></ray></sensor>)");
  const AngleLimits view = viewFromUrdf(urdf, "laser");
  EXPECT_NEAR(view.low, -1.0, 0.01);
  EXPECT_NEAR(view.high, 0.5, 0.01);
}

TEST(UrdfView, IsUnlimitedWithoutASensor) {
  EXPECT_TRUE(std::isinf(viewFromUrdf(kRobot, "laser").low));
  EXPECT_TRUE(std::isinf(viewFromUrdf("", "laser").high));
  EXPECT_TRUE(std::isinf(viewFromUrdf("<robot", "laser").high));
}

}  // namespace
}  // namespace adaptive_localization
