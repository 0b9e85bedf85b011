// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/sonar_ring.hpp"

#include <gmock/gmock.h>

#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

Observations hearing(double stamp, const std::vector<SonarReading>& readings) {
  Observations observations;
  observations.stamp = stamp;
  observations.sonar = readings;
  return observations;
}

SonarReading reading(int sonar, double range) {
  return {sonar, {0.1, 0.0, 0.5}, range, 5.0, 0.5};
}

TEST(ASonarRing, KeepsTheNewestReadingOfEach) {
  SonarRing ring;
  ring.hear({}, hearing(1.0, {reading(0, 1.0), reading(1, 2.0)}));
  ring.hear({}, hearing(1.1, {reading(1, 2.1)}));
  const auto kept = ring.readingsFrom({});
  ASSERT_THAT(kept, SizeIs(2));
  EXPECT_EQ(kept[0].range, 1.0);
  EXPECT_EQ(kept[1].range, 2.1);
}

TEST(ASonarRing, MovesThemAlongWithTheOdometry) {
  SonarRing ring;
  const Pose2 then{1.0, 2.0, 0.3}, now = then * Pose2{0.2, 0.0, 0.1};
  ring.hear(then, hearing(1.0, {reading(0, 1.0)}));
  const auto kept = ring.readingsFrom(now);
  ASSERT_THAT(kept, SizeIs(1));
  EXPECT_THAT(now * kept[0].T_base_sonar, PoseNear(then * (Pose2{0.1, 0.0, 0.5}), 1e-9, 1e-9));
}

TEST(ASonarRing, DropsOldReadingsAndForgets) {
  SonarRing ring;
  ring.hear({}, hearing(1.0, {reading(0, 1.0)}));
  ring.hear({}, hearing(2.5, {reading(1, 1.0)}));
  EXPECT_THAT(ring.readingsFrom({}), SizeIs(2));
  ring.hear({}, hearing(3.5, {}));
  EXPECT_THAT(ring.readingsFrom({}), SizeIs(1));
  ring.forget();
  EXPECT_THAT(ring.readingsFrom({}), IsEmpty());
}

}  // namespace
}  // namespace adaptive_localization
