// SPDX-License-Identifier: BSD-3-Clause
#include "ros/conversions.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace adaptive_localization {
namespace {

geometry_msgs::Transform transformOf(double x, double y, const Eigen::Quaterniond& rotation) {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() = rotation.toRotationMatrix();
  transform.translation() << x, y, 0.3;
  return toTransformMessage(transform);
}

TEST(Conversions, PosesGoThereAndBack) {
  for (const double theta : {-3.1, -1.0, 0.0, 0.5, 3.1}) {
    const Pose2 pose{1.5, -2.5, theta};
    for (const Pose2& back : {toPose2(toPoseMessage(pose)), toPose2(toTransformMessage(pose))}) {
      EXPECT_DOUBLE_EQ(back.x, pose.x);
      EXPECT_DOUBLE_EQ(back.y, pose.y);
      EXPECT_NEAR(back.theta, pose.theta, 1e-12);
    }
  }
}

TEST(Conversions, UnfilledQuaternionIsNoRotation) {
  EXPECT_EQ(toPose2(geometry_msgs::Pose()).theta, 0.0);
}

TEST(Conversions, NotFiniteQuaternionShowsInThePose) {
  geometry_msgs::Pose message;
  message.orientation.w = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isFinite(toPose2(message)));
}

TEST(Conversions, QuaternionTooLongToMeasureIsNotFinite) {
  geometry_msgs::Pose message;
  message.orientation.z = message.orientation.w = 1e300;
  EXPECT_FALSE(isFinite(toPose2(message)));
}

TEST(Conversions, MapThatIsTiltedIsRefused) {
  nav_msgs::OccupancyGrid message;
  message.info.width = message.info.height = 1;
  message.info.resolution = 0.05F;
  message.data = {0};
  message.info.origin.orientation.w = 1.0;
  EXPECT_NO_THROW(toGrid(message));
  message.info.origin.orientation.x = 0.05;  // 6 degrees: of a map that was fitted to a floor
  EXPECT_NO_THROW(toGrid(message));
  message.info.origin.orientation.x = 1.0;
  EXPECT_THROW(toGrid(message), std::invalid_argument);
}

TEST(Conversions, PlacesThatAreNoneAreNamed) {
  EXPECT_NO_THROW(checkPlace("laser", "base", -5.0, 100.0, 100.0));
  for (const double x : {1e30, -101.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(checkPlace("laser", "base", x, 0.0, 100.0), std::runtime_error);
    EXPECT_THROW(checkPlace("laser", "base", 0.0, x, 100.0), std::runtime_error);
  }
}

TEST(Conversions, OneLeadingSlashIsTaken) {
  EXPECT_EQ(withoutLeadingSlash("/map"), "map");
  EXPECT_EQ(withoutLeadingSlash("map"), "map");
  EXPECT_EQ(withoutLeadingSlash(""), "");
}

TEST(Conversions, LevelAndUpsideDownLasersAreToldApart) {
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  const LaserMount level = toMount(transformOf(0.1, 0.2, turned));
  EXPECT_TRUE(level.axes.isApprox(LaserMount::level({0.1, 0.2, 0.5}).axes));
  EXPECT_EQ(level.position, Eigen::Vector2d(0.1, 0.2));
  const Eigen::Quaterniond flipped(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  const LaserMount upside_down = toMount(transformOf(0.1, 0.2, turned * flipped));
  EXPECT_TRUE(upside_down.axes.isApprox(LaserMount::upsideDown({0.1, 0.2, 0.5}).axes, 1e-9));
}

TEST(Conversions, CovarianceStandsAtXYAndYaw) {
  Eigen::Matrix3d covariance;
  covariance << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  const auto message = toMessage(Pose2{}, covariance);
  EXPECT_EQ(message.covariance[0], 1);
  EXPECT_EQ(message.covariance[1], 2);
  EXPECT_EQ(message.covariance[5], 3);
  EXPECT_EQ(message.covariance[7], 4);
  EXPECT_EQ(message.covariance[11], 5);
  EXPECT_EQ(message.covariance[30], 3);
  EXPECT_EQ(message.covariance[35], 6);
  EXPECT_EQ(message.covariance[14], 0);

  Eigen::Matrix3d read;  // as amcl does: without the terms between position and yaw
  read << 1, 2, 0, 2, 4, 0, 0, 0, 6;
  EXPECT_EQ(toGaussian(message).covariance, read);
}

TEST(Conversions, MapUpdatesKeepTheirPlaceAndSize) {
  map_msgs::OccupancyGridUpdate message;
  message.x = 3;
  message.y = -4;
  message.width = 2;
  message.height = std::numeric_limits<std::uint32_t>::max();
  message.data = {100, -1};
  const MapPatch patch = toPatch(message);
  EXPECT_EQ(patch.corner.x, 3);
  EXPECT_EQ(patch.corner.y, -4);
  EXPECT_EQ(patch.width, 2);
  EXPECT_EQ(patch.height, -1) << "no size that a map has";
  EXPECT_EQ(patch.cells, message.data);
}

TEST(Conversions, MapsGoThereAndBack) {
  const OccupancyGrid grid(Lattice(3, 2, 0.5, {1.0, 2.0, 0.25}), {0, 100, -1, 50, 0, 0});
  const OccupancyGrid back = toGrid(toMessage(grid));
  EXPECT_EQ(back.cells(), grid.cells());
  EXPECT_EQ(back.lattice().width(), 3);
  EXPECT_NEAR(back.lattice().origin().theta, 0.25, 1e-12);
}

TEST(Conversions, MapWithWrongSizesIsRefused) {
  nav_msgs::OccupancyGrid message = toMessage(OccupancyGrid(Lattice(2, 2, 0.5, {}), {0, 0, 0, 0}));
  message.data.pop_back();
  EXPECT_THROW(toGrid(message), std::invalid_argument);
  message.info.width = 4000000000;
  EXPECT_THROW(toGrid(message), std::invalid_argument);
  EXPECT_THROW(toGrid(nav_msgs::OccupancyGrid()), std::invalid_argument);
}

TEST(ToGrid, TheOriginIsTheFirstCellsCornerOrItsCentre) {
  nav_msgs::OccupancyGrid message;
  message.info.width = message.info.height = 2;
  message.info.resolution = 0.5F;
  message.info.origin = toPoseMessage({1.0, 2.0, kPi / 2});
  message.data = {0, 100, 37, -1};
  EXPECT_NEAR(toGrid(message).lattice().origin().x, 1.0, 1e-9);
  const Pose2 shifted = toGrid(message, true).lattice().origin();
  EXPECT_NEAR(shifted.x, 1.25, 1e-9);
  EXPECT_NEAR(shifted.y, 1.75, 1e-9);
}

}  // namespace
}  // namespace adaptive_localization
