// SPDX-License-Identifier: BSD-3-Clause
#include "core/reflectors.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace adaptive_localization {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class Reflectors : public testing::Test {
 protected:
  Reflectors() {
    scan_.angle_min = -kPi / 2;
    scan_.angle_increment = kPi / 180;
    scan_.range_max = 8.0;
    scan_.ranges.assign(181, 4.0F);
    scan_.intensities.assign(181, 10.0F);
    options_.reflector_intensity = 100.0;
  }

  void shine(int from, int to, float range) {
    for (int i = from; i <= to; ++i) {
      scan_.intensities[static_cast<std::size_t>(i)] = 200.0F;
      scan_.ranges[static_cast<std::size_t>(i)] = range;
    }
  }

  std::optional<std::vector<Sighting>> told() const {
    Observations observations;
    addReflectors(scan_, mount_, options_, velocity_, observations);
    return observations.landmarks;
  }
  std::vector<Sighting> reflectors() const { return told().value(); }

  LaserScan scan_;
  LaserMount mount_;
  ScanOptions options_;
  BaseVelocity velocity_;
};

TEST_F(Reflectors, AreBrightRunsOfBeams) {
  shine(89, 91, 3.0F);
  shine(120, 120, 2.0F);
  const auto sightings = reflectors();
  ASSERT_THAT(sightings, SizeIs(2));
  EXPECT_EQ(sightings[0].id, -1);
  EXPECT_NEAR(sightings[0].range, 3.0, 0.001);
  EXPECT_NEAR(sightings[0].bearing, 0.0, 1e-6);
  EXPECT_NEAR(sightings[0].bearing_deviation, 1.5 * kPi / 180, 1e-6);
  EXPECT_NEAR(sightings[1].bearing, kPi / 6, 1e-6);
  EXPECT_NEAR(sightings[1].bearing_deviation, kPi / 180, 1e-6);
  EXPECT_NEAR(sightings[1].range_deviation, 0.05, 1e-9);
}

TEST_F(Reflectors, OneBehindAnotherAreTwo) {
  shine(60, 62, 3.0F);
  shine(63, 65, 5.0F);
  EXPECT_THAT(reflectors(), SizeIs(2));
}

TEST_F(Reflectors, AreSeenFromBase) {
  shine(90, 90, 3.0F);
  mount_ = LaserMount::level({0.5, 0.0, kPi / 2});
  const auto sightings = reflectors();
  ASSERT_THAT(sightings, SizeIs(1));
  EXPECT_NEAR(sightings[0].range, std::hypot(0.5, 3.0), 1e-6);
  EXPECT_NEAR(sightings[0].bearing, std::atan2(3.0, 0.5), 1e-6);
}

TEST_F(Reflectors, AreNoneWhereNothingIsBrightOrHasARange) {
  EXPECT_THAT(reflectors(), IsEmpty());
  shine(80, 82, std::numeric_limits<float>::infinity());
  shine(83, 84, std::numeric_limits<float>::quiet_NaN());
  shine(85, 86, 20.0F);
  EXPECT_THAT(reflectors(), IsEmpty());
}

TEST_F(Reflectors, AreWhereTheyWereWhenTheFirstBeamWasSent) {
  shine(180, 180, 3.0F);
  scan_.time_increment = 0.1 / 180;
  velocity_.turn = 0.5;
  EXPECT_NEAR(reflectors()[0].bearing, kPi / 2 + 0.05, 1e-6);
  options_.deskew = false;
  EXPECT_NEAR(reflectors()[0].bearing, kPi / 2, 1e-6);
}

TEST_F(Reflectors, AreWithinTheViewAndTheLimitsThatScansAreReadWith) {
  scan_.range_max = std::numeric_limits<double>::infinity();
  shine(10, 10, std::numeric_limits<float>::infinity());
  EXPECT_THAT(reflectors(), IsEmpty());
  shine(20, 20, 0.3F);
  shine(90, 90, 3.0F);
  shine(120, 120, 6.0F);
  EXPECT_THAT(reflectors(), SizeIs(3));
  options_.laser_min_range = 0.5;
  EXPECT_THAT(reflectors(), SizeIs(2));
  options_.laser_max_range = 5.0;
  EXPECT_THAT(reflectors(), SizeIs(1));
  mount_.view = {-kPi / 2, -0.1};
  EXPECT_THAT(reflectors(), IsEmpty());
}

TEST_F(Reflectors, AreNotToldUnaskedOrWithoutIntensities) {
  shine(90, 90, 3.0F);
  ASSERT_THAT(reflectors(), SizeIs(1));
  scan_.intensities.resize(10);
  EXPECT_FALSE(told());
  scan_.intensities.clear();
  EXPECT_FALSE(told());
  scan_.intensities.assign(181, 200.0F);
  options_.reflector_intensity = 0.0;
  EXPECT_FALSE(told());
}

TEST_F(Reflectors, ComeBesideWhatIsSightedOtherwise) {
  shine(90, 90, 3.0F);
  Sighting post;
  post.id = 4;
  Observations observations;
  observations.landmarks = {post};
  addReflectors(scan_, mount_, options_, velocity_, observations);
  EXPECT_THAT(
      observations.landmarks.value(),
      testing::ElementsAre(testing::Field(&Sighting::id, 4), testing::Field(&Sighting::id, -1)));
}

}  // namespace
}  // namespace adaptive_localization
