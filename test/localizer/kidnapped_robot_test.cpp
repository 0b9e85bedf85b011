// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a robot that is carried away, for all cores with which the localizer recovers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "adaptive_localization/localizer/localizer.hpp"
#include "ser/places.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

const Pose2 kHere{1.2, 1.1, 0.3};
const Pose2 kThere{8.2, 3.9, 2.5};

const std::vector<std::string> kCoresThatRecover{"amcl", "samcl", "sa_kld",  "pso",
                                                 "ba",   "lbba",  "ekf_icp", "markov"};

class KidnappedRobot : public testing::Test {
 protected:
  std::unique_ptr<Localizer> make(const std::string& name,
                                  const std::string& preset = "recommended", int seed = 1) const {
    Parameters parameters;
    parameters.set("filter", name);
    parameters.set("preset", preset);
    parameters.set("seed", seed);
    return std::make_unique<Localizer>(parameters, map_);
  }

  void track(Localizer& localizer) const {
    localizer.reset(Gaussian2{kHere, Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal()});
    for (int i = 0; i < 40; ++i) update(localizer, {}, seenFrom(kHere));  // 4 s of a laser
  }

  std::unique_ptr<Localizer> makeTracking(const std::string& name,
                                          const std::string& preset = "recommended",
                                          int seed = 1) const {
    auto localizer = make(name, preset, seed);
    track(*localizer);
    return localizer;
  }

  /// One more scan, whether the robot moved or not.
  static Localization update(Localizer& localizer, const Pose2& T_odom_base,
                             const Observations& seen) {
    localizer.requestUpdate();
    return localizer.update(T_odom_base, seen);
  }

  Observations seenFrom(const Pose2& pose) const {
    return ToyLaser{91, -2.0, 2.0, 10.0}.observe(map_, pose);
  }

  /// Scans from there until the localizer says so; 100 if it never does.
  int scansUntilFound(Localizer& localizer, const Pose2& there, int most = 60) const {
    for (int i = 1; i <= most; ++i) {
      const Localization answer = update(localizer, {}, seenFrom(there));
      if (testing::Value(answer.T_map_base, PoseNear(there, 0.15, 0.087))) return i;
    }
    return 100;
  }

  std::shared_ptr<const OccupancyGrid> map_ = asymmetricWorld();
};

TEST_F(KidnappedRobot, IsFoundWithinThreeScansByAllThatRecover) {
  for (const std::string& core : kCoresThatRecover) {
    for (int seed = 1; seed <= 3; ++seed) {
      EXPECT_LE(scansUntilFound(*makeTracking(core, "recommended", seed), kThere), 3)
          << core << ", seed " << seed;
    }
  }
  EXPECT_EQ(scansUntilFound(*makeTracking("kld"), kThere), 100);
}

/// Also where what may be searched in an update is a small part of what it takes.
TEST_F(KidnappedRobot, IsFoundByASearchInParts) {
  constexpr SearchWork kStep = 10000;  // of a search, at the most
  for (const std::string& core : kCoresThatRecover) {
    const auto field = std::make_shared<const DistanceField>(*map_);
    const auto places =
        std::make_shared<Places>(map_, field, EnergyGridOptions{}, GlobalSearchOptions{});
    Parameters parameters;
    parameters.set("filter", core);
    parameters.set("update_budget", 0.05);  // ms, 2000 poses
    Localizer localizer(parameters, Ground(map_, field, places));
    track(localizer);
    int scans = 0;
    bool is_found = false;
    for (; scans < 60 && !is_found; ++scans) {
      const Localization answer = update(localizer, {}, seenFrom(kThere));
      is_found = testing::Value(answer.T_map_base, PoseNear(kThere, 0.15, 0.087));
      EXPECT_GT(places->workLeft(), -kStep) << core << ", scan " << scans;
    }
    EXPECT_TRUE(is_found) << core;
    EXPECT_GT(scans, 3) << core << ": as if it were searched for at once";
  }
}

/// What updates may not do is done between them, by the time that there is from scan to scan.
TEST_F(KidnappedRobot, IsFoundSoonerBySearchingBetweenScans) {
  const auto scansBy = [&](double share, double interval) {
    const auto localizer = make("sa_kld");
    Parameters parameters;
    parameters.set("filter", std::string("sa_kld"));
    parameters.set("update_budget", 0.05);  // ms, 2000 poses
    parameters.set("search_share", share);
    localizer->configure(parameters);
    track(*localizer);
    Observations seen = seenFrom(kThere);
    for (int scans = 1; scans < 60; ++scans) {
      seen.stamp += interval;
      const Localization answer = update(*localizer, {}, seen);
      if (testing::Value(answer.T_map_base, PoseNear(kThere, 0.15, 0.087))) return scans;
      localizer->searchOn();
    }
    return 60;
  };
  const int without = scansBy(0.0, 0.1);
  EXPECT_GT(without, 6);
  EXPECT_LT(without, 60);
  EXPECT_LE(scansBy(0.25, 0.1), 4);
  EXPECT_LT(scansBy(0.001, 0.1), without);
  for (const double no_time : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(scansBy(0.25, no_time), scansBy(0.0, no_time)) << no_time;
  }
}

TEST_F(KidnappedRobot, IsFoundByThePresetsOfTheSources) {
  for (const std::string core : {"samcl", "sa_kld"}) {
    EXPECT_LE(scansUntilFound(*makeTracking(core, "seed"), kThere), 60) << core;
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
  for (const std::string& core : kCoresThatRecover) {
    const auto localizer = makeTracking(core);
    Pose2 truth = kHere;
    Pose2 T_odom_base;
    for (int i = 0; i < 20; ++i) {
      truth = truth * step;
      T_odom_base = T_odom_base * step;
      const Localization answer = update(*localizer, T_odom_base, covered);
      EXPECT_THAT(answer.T_map_base, PoseNear(truth, 0.1, 0.1)) << core << ", scan " << i;
    }
    EXPECT_THAT(update(*localizer, T_odom_base, seenFrom(truth)).T_map_base,
                PoseNear(truth, 0.1, 0.1))
        << core;
  }
}

/// As long as a pose is kept that a core has left, nobody is told that it is as sure as the core
/// is.
TEST_F(KidnappedRobot, KeepsAPoseWithACovarianceOfItsOwn) {
  int kept = 0;
  for (const std::string& core : kCoresThatRecover) {
    const auto localizer = makeTracking(core);
    for (int i = 0; i < 4; ++i) {
      const Pose2 too_far_to_see_it{0.6, 0.0, 0.0};
      const Localization answer = update(*localizer, too_far_to_see_it, seenFrom(kThere));
      const Pose2& mean = answer.estimate.T_map_base;
      const Eigen::Vector3d off(mean.x - answer.T_map_base.x, mean.y - answer.T_map_base.y,
                                wrapAngle(mean.theta - answer.T_map_base.theta));
      const Eigen::Matrix3d expected = answer.estimate.covariance + off * off.transpose();
      EXPECT_TRUE(answer.covariance.isApprox(expected, 1e-9)) << core << ", scan " << i;
      if (off.norm() < 1.0) continue;
      ++kept;
      EXPECT_LT(answer.confidence, 0.1) << core << ", scan " << i;
    }
  }
  EXPECT_GT(kept, 0);
}

TEST_F(KidnappedRobot, ThatMayBeAnywhereIsFoundInTheFirstScan) {
  for (const std::string core : {"amcl", "sa_kld", "ekf_icp", "lbba"}) {
    const auto localizer = make(core);
    localizer->reset(Anywhere{});
    EXPECT_EQ(scansUntilFound(*localizer, kHere), 1) << core;
  }
}

TEST_F(KidnappedRobot, NeedsFewerParticlesWhereAScanLeavesFewPlaces) {
  const auto localizer = make("sa_kld");
  localizer->reset(Anywhere{});
  EXPECT_EQ(localizer->hypotheses().size(), 20000);
  update(*localizer, {}, seenFrom(kHere));
  EXPECT_LT(localizer->hypotheses().size(), 5000);
}

}  // namespace
}  // namespace adaptive_localization
