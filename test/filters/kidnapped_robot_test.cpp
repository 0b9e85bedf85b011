// SPDX-License-Identifier: BSD-3-Clause
// The cores that look elsewhere, with all their parts.
#include <gtest/gtest.h>

#include <cmath>

#include "adaptive_localization/filters/builtins.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kHere{1.2, 1.1, 0.3};
const Pose2 kThere{8.2, 3.9, 2.5};

class KidnappedRobot : public testing::Test {
 protected:
  std::unique_ptr<Filter> make(const std::string& name, const std::string& preset = "recommended",
                               std::uint64_t seed = 1) {
    const FilterDescription& description = builtins().filters.find(name);
    FilterContext context{builtins(), map_, {}, seed};
    for (const auto& [key, value] : preset == "seed" ? description.seed : description.recommended) {
      context.parameters.set(key, value);
    }
    return description.make(context);
  }

  std::unique_ptr<Filter> makeTracking(const std::string& name,
                                       const std::string& preset = "recommended",
                                       std::uint64_t seed = 1) {
    auto filter = make(name, preset, seed);
    filter->reset(Gaussian2{kHere, Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal()});
    for (int i = 0; i < 10; ++i) filter->update({}, seenFrom(kHere));
    return filter;
  }

  Observations seenFrom(const Pose2& pose) const {
    return ToyLaser{91, -2.0, 2.0, 10.0}.observe(map_, pose);
  }

  /// Scans from there until the filter says so; 100 if it never does.
  int scansUntilFound(Filter& filter, const Pose2& there, int most = 60) const {
    for (int i = 1; i <= most; ++i) {
      const Estimate estimate = filter.update({}, seenFrom(there));
      if (testing::Value(estimate.T_map_base, PoseNear(there, 0.15, 0.087))) return i;
    }
    return 100;
  }

  std::shared_ptr<const OccupancyGrid> map_ = asymmetricWorld();
};

TEST_F(KidnappedRobot, IsFoundWithinThreeScansBySaKld) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto filter = makeTracking("sa_kld", "recommended", seed);
    EXPECT_LE(scansUntilFound(*filter, kThere), 3) << "seed " << seed;
  }
}

TEST_F(KidnappedRobot, IsFoundByAllThatLook) {
  for (const auto& [core, scans] : {std::pair{"amcl", 30}, {"samcl", 20}}) {
    const auto filter = makeTracking(core);
    EXPECT_LE(scansUntilFound(*filter, kThere), scans) << core;
  }
  EXPECT_EQ(scansUntilFound(*makeTracking("kld"), kThere), 100);
}

TEST_F(KidnappedRobot, IsFoundByThePresetsOfTheSources) {
  for (const std::string core : {"samcl", "sa_kld"}) {
    const auto filter = makeTracking(core, "seed");
    EXPECT_LE(scansUntilFound(*filter, kThere), 60) << core;
  }
}

TEST_F(KidnappedRobot, WithACoveredLaserIsWhereOdometrySays) {
  Observations covered = seenFrom(kHere);
  Scan& scan = covered.scan;
  for (Eigen::Index i = 0; i < scan.range.size(); ++i) {
    scan.range[i] = 0.05F + 0.001F * static_cast<float>(i % 7);
    scan.x[i] = scan.range[i] * std::cos(scan.bearing[i]);
    scan.y[i] = scan.range[i] * std::sin(scan.bearing[i]);
  }
  const Pose2 step{0.05, 0.0, 0.02};
  for (const std::string core : {"samcl", "sa_kld"}) {
    const auto filter = makeTracking(core);
    Pose2 truth = kHere;
    for (int i = 0; i < 20; ++i) {
      truth = truth * step;
      const Estimate estimate = filter->update(step, covered);
      EXPECT_THAT(estimate.T_map_base, PoseNear(truth, 0.2, 0.15)) << core << ", scan " << i;
    }
    EXPECT_THAT(filter->update({}, seenFrom(truth)).T_map_base, PoseNear(truth, 0.1, 0.1)) << core;
  }
}

TEST_F(KidnappedRobot, ThatMayBeAnywhereIsFoundInTheFirstScan) {
  for (const std::string core : {"amcl", "sa_kld"}) {
    const auto filter = make(core);
    filter->reset(Anywhere{});
    EXPECT_EQ(scansUntilFound(*filter, kHere), 1) << core;
  }
}

TEST_F(KidnappedRobot, NeedsFewerParticlesWhereAScanLeavesFewPlaces) {
  const auto filter = make("sa_kld");
  filter->reset(Anywhere{});
  EXPECT_EQ(filter->hypotheses().size(), 20000);
  filter->update({}, seenFrom(kHere));
  EXPECT_LT(filter->hypotheses().size(), 5000);
}

}  // namespace
}  // namespace adaptive_localization
