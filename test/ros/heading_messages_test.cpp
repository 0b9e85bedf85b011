// SPDX-License-Identifier: BSD-3-Clause
#include "bag/heading_messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {
namespace {

const Eigen::Matrix3d kLevel = Eigen::Matrix3d::Identity();

Eigen::Matrix3d turned(double yaw) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

Eigen::Matrix3d upsideDown() {
  return Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

geometry_msgs::Quaternion toMessage(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  geometry_msgs::Quaternion message;
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
  return message;
}

sensor_msgs::Imu imu(const Eigen::Matrix3d& R_world_sensor) {
  sensor_msgs::Imu message;
  message.orientation = toMessage(R_world_sensor);
  message.orientation_covariance[0] = message.orientation_covariance[4] = 1.0;
  message.orientation_covariance[8] = 0.04;
  message.angular_velocity_covariance[8] = 0.01;
  return message;
}

template <class Call>
void expectRefused(const Call& call, const std::string& why) {
  try {
    call();
    ADD_FAILURE() << "expected: " << why;
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(why));
  }
}

TEST(HeadingMessages, AnImuTellsTheYawOfBaseHoweverItSits) {
  const Eigen::Matrix3d R_world_base = turned(0.7);
  for (const Eigen::Matrix3d& R_base_sensor :
       {kLevel, turned(1.2), upsideDown(), Eigen::Matrix3d(turned(-2.0) * upsideDown())}) {
    const Heading heading = headingOf(imu(R_world_base * R_base_sensor), R_base_sensor);
    EXPECT_NEAR(heading.theta, 0.7, 1e-9);
    EXPECT_NEAR(heading.deviation, 0.2, 1e-9);
  }
}

TEST(HeadingMessages, AnImuUpsideDownTurnsTheOtherWay) {
  sensor_msgs::Imu message = imu(kLevel);
  message.angular_velocity.z = 0.5;
  EXPECT_NEAR(turnRateOf(message, kLevel).rate, 0.5, 1e-9);
  EXPECT_NEAR(turnRateOf(message, upsideDown()).rate, -0.5, 1e-9);
  EXPECT_NEAR(turnRateOf(message, kLevel).deviation, 0.1, 1e-9);
}

TEST(HeadingMessages, MinusOneSaysThatThereIsNone) {
  sensor_msgs::Imu message = imu(kLevel);
  EXPECT_TRUE(hasHeading(message));
  EXPECT_TRUE(hasTurnRate(message));
  message.orientation_covariance[0] = message.angular_velocity_covariance[0] = -1.0;
  EXPECT_FALSE(hasHeading(message));
  EXPECT_FALSE(hasTurnRate(message));
}

TEST(HeadingMessages, TheFieldPointsNorth) {
  sensor_msgs::MagneticField message;
  message.magnetic_field.x = 2e-5;
  message.magnetic_field.z = -4e-5;  // and down
  message.magnetic_field_covariance[0] = message.magnetic_field_covariance[4] = 1e-12;
  EXPECT_NEAR(headingOf(message, kLevel).theta, kPi / 2, 1e-9);  // base points north
  EXPECT_NEAR(headingOf(message, kLevel).deviation, 1e-6 / 2e-5, 1e-9);
  message.magnetic_field.x = 0.0;
  message.magnetic_field.y = 2e-5;  // north is to the left: base points east
  EXPECT_NEAR(headingOf(message, kLevel).theta, 0.0, 1e-9);
  EXPECT_NEAR(headingOf(message, turned(kPi / 2)).theta, -kPi / 2, 1e-9);
}

TEST(HeadingMessages, AQuaternionHasNoDeviation) {
  geometry_msgs::QuaternionStamped message;
  message.quaternion = toMessage(turned(-2.0));
  EXPECT_NEAR(headingOf(message, kLevel).theta, -2.0, 1e-9);
  EXPECT_EQ(headingOf(message, kLevel).deviation, 0.0);
}

TEST(HeadingMessages, NonsenseIsRefusedByName) {
  sensor_msgs::Imu message = imu(kLevel);
  message.orientation = geometry_msgs::Quaternion();
  expectRefused([&] { headingOf(message, kLevel); }, "length of a quaternion: got 0");
  message.orientation.w = std::numeric_limits<double>::quiet_NaN();
  expectRefused([&] { headingOf(message, kLevel); }, "length of a quaternion: got nan");
  message = imu(upsideDown());
  expectRefused([&] { headingOf(message, kLevel); }, "tilt of the robot in degrees: got 180");
  message = imu(kLevel);
  message.orientation_covariance[8] = -0.5;
  expectRefused([&] { headingOf(message, kLevel); }, "variance: got -0.5");
  message.angular_velocity.z = std::numeric_limits<double>::infinity();
  expectRefused([&] { turnRateOf(message, kLevel); }, "turn rate: got inf");
  sensor_msgs::MagneticField field;
  field.magnetic_field.z = 4e-5;
  expectRefused([&] { headingOf(field, kLevel); }, "horizontal magnetic field in tesla: got 0");
}

}  // namespace
}  // namespace adaptive_localization
