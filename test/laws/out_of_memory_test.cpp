// SPDX-License-Identifier: BSD-3-Clause
// A localizer that is refused memory, at any allocation: it throws, and goes on with the next scan
// as if nothing had been.
#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "adaptive_localization/filters/builtins.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "support/allocations.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

/// Calls `work`, whose n-th allocation gets no memory; says whether it was one too many for it.
template <typename Work>
bool failsAt(long n, const Work& work) {
  allocations::until_failure = n;
  try {
    work();
  } catch (const std::exception&) {  // std::bad_alloc, or what OpenCV makes of it
    allocations::until_failure = 0;
    return true;
  }
  allocations::until_failure = 0;
  return false;
}

class EveryCore : public testing::TestWithParam<std::string> {
 protected:
  static Parameters parameters() {
    Parameters parameters;
    parameters.set("filter", GetParam());
    parameters.set("threads", 1);
    return parameters;
  }

  std::shared_ptr<const OccupancyGrid> map_{asymmetricWorld()};
  std::vector<ToyStep> drive_{toyDrive(map_, 1, 61)};
  Prior start_{Gaussian2{drive_.front().T_map_base, 0.001 * Eigen::Matrix3d::Identity()}};

  /// Tracked for the first ten steps.
  void driveTo(Localizer& localizer) {
    localizer.reset(start_);
    step_ = 0;
    T_odom_base_ = {};
    while (step_ < 10) drive(localizer);
  }

  /// One step of the drive, after which the robot is where it should be.
  void drive(Localizer& localizer) {
    T_odom_base_ = T_odom_base_ * drive_[step_].motion;
    const Localization now = localizer.update(T_odom_base_, drive_[step_].observations);
    const Pose2 error = between(drive_[step_].T_map_base, now.T_map_base);
    ASSERT_LT(std::hypot(error.x, error.y), 0.2) << "at step " << step_;
    ++step_;
  }

  std::size_t step_{0};
  Pose2 T_odom_base_;
};

/// Refuses memory to `work` at ever later allocations, until none is refused, and calls `check`
/// after each.
template <typename Work, typename Check>
long failAllAlong(const Work& work, const Check& check) {
  long n = 1, failures = 0;
  while (failsAt(n, work)) {
    ++failures;
    check(n);
    if (testing::Test::HasFatalFailure()) break;
    n += 1 + n / 4;
  }
  return failures;
}

/// Every second update fails, each time at another allocation.
TEST_P(EveryCore, TracksOnWhereUpdatesRunOutOfMemory) {
  long n = 0;
  bool failed = true;
  while (failed) {  // until no update allocates as often
    failed = false;
    Localizer localizer(parameters(), Ground(map_));
    localizer.reset(start_);
    Pose2 T_odom_base;
    Localization last;
    for (std::size_t i = 0; i < drive_.size(); ++i) {
      T_odom_base = T_odom_base * drive_[i].motion;
      const auto update = [&] { last = localizer.update(T_odom_base, drive_[i].observations); };
      if (i % 2 == 0) {
        update();
      } else {
        failed = failsAt(++n, update) || failed;
      }
    }
    const Pose2 error = between(drive_.back().T_map_base, last.T_map_base);
    ASSERT_LT(std::hypot(error.x, error.y), 0.15) << "up to allocation " << n;
    ASSERT_EQ(last.status, Status::kTracking) << "up to allocation " << n;
  }
  RecordProperty("allocations", std::to_string(n));
  EXPECT_GT(n, 20) << "nothing failed";
}

/// The motion of an update that failed is not moved again with that of the next one.
TEST_P(EveryCore, MovesByWhatIsLeftWhereAnUpdateRanOutOfMemory) {
  const Observations seen = ToyLaser{61, -2.0, 2.0, 12.0}.observe(map_, {3.0, 1.0, 0.0});
  const FilterDescription& description = builtins().filters.find(GetParam());
  FilterContext context{builtins(), Ground(map_), parameters(), 1};
  for (const auto& [key, value] : description.preset("recommended")) {
    context.parameters.set(key, value);
  }
  const auto filter = description.make(context);
  const Prior start = Gaussian2{{2.0, 1.0, 0.0}, 1e-4 * Eigen::Matrix3d::Identity()};
  filter->reset(start);
  const auto update = [&] { filter->update({1.0, 0.0, 0.0}, seen); };
  const long failures = failAllAlong(update, [&](long n) {
    SCOPED_TRACE("allocation " + std::to_string(n));
    const Estimate now = filter->update({1.5, 0.0, 0.0}, {});
    EXPECT_THAT(now.T_map_base, PoseNear(Pose2{3.5, 1.0, 0.0}, 0.3, 0.1));
    filter->reset(start);
  });
  EXPECT_GT(failures, 5) << "nothing failed";
}

/// All but those that by definition look nowhere else.
std::vector<std::string> searchingCores() {
  std::vector<std::string> names = builtins().filters.names();
  const auto is_plain = [](const std::string& name) { return name == "mcl" || name == "kld"; };
  names.erase(std::remove_if(names.begin(), names.end(), is_plain), names.end());
  return names;
}

class SearchingCore : public EveryCore {};

/// Searches of the map fail at ever later allocations.
TEST_P(SearchingCore, IsFoundWhereSearchesRunOutOfMemory) {
  int failures = 0;
  for (long n = 1, last_failures = -1; failures > last_failures; n += 1 + n / 4) {
    last_failures = failures;
    Localizer localizer(parameters(), Ground(map_));
    localizer.reset(Anywhere{});
    Pose2 T_odom_base;
    Localization last;
    for (std::size_t i = 0; i < drive_.size(); ++i) {
      T_odom_base = T_odom_base * drive_[i].motion;
      const auto update = [&] { last = localizer.update(T_odom_base, drive_[i].observations); };
      failures += failsAt(i < 3 ? n : 0, update) ? 1 : 0;
    }
    const Pose2 error = between(drive_.back().T_map_base, last.T_map_base);
    ASSERT_LT(std::hypot(error.x, error.y), 0.2) << "allocation " << n;
    ASSERT_EQ(last.status, Status::kTracking) << "allocation " << n;
  }
  EXPECT_GT(failures, 20) << "nothing failed";
}

/// The robot is where it was, and so is the filter, or the new one is there.
TEST_P(EveryCore, KeepsItsPlaceWhereAReconfigurationRunsOutOfMemory) {
  Localizer localizer(parameters(), Ground(map_));
  driveTo(localizer);
  Parameters other = parameters();
  other.set("filter", std::string(GetParam() == "ekf_icp" ? "kld" : "ekf_icp"));
  const auto configure = [&] { localizer.configure(other); };
  const long failures = failAllAlong(configure, [&](long n) {
    SCOPED_TRACE("allocation " + std::to_string(n));
    ASSERT_EQ(localizer.options().filter, GetParam());
    if (step_ < drive_.size()) drive(localizer);
  });
  EXPECT_GT(failures, 5) << "nothing failed";
  EXPECT_NE(localizer.options().filter, GetParam());
}

TEST_P(EveryCore, KeepsItsMapWhereANewOneRunsOutOfMemory) {
  Localizer localizer(parameters(), Ground(map_));
  driveTo(localizer);
  const Ground other(asymmetricWorld());
  const auto change = [&] { localizer.setMap(other); };
  const long failures = failAllAlong(change, [&](long n) {
    SCOPED_TRACE("allocation " + std::to_string(n));
    ASSERT_NE(&localizer.field(), other.field.get());
    if (step_ < drive_.size()) drive(localizer);
  });
  EXPECT_GT(failures, 5) << "nothing failed";
  EXPECT_EQ(&localizer.field(), other.field.get());
}

/// An initial pose that was refused can be given again.
TEST_P(EveryCore, StartsWhereTheFirstTryRanOutOfMemory) {
  Localizer localizer(parameters(), Ground(map_));
  const auto start = [&] { localizer.reset(start_); };
  failAllAlong(start, [&](long n) {
    SCOPED_TRACE("allocation " + std::to_string(n));
    driveTo(localizer);
  });
  driveTo(localizer);
}

INSTANTIATE_TEST_SUITE_P(Laws, SearchingCore, testing::ValuesIn(searchingCores()),
                         [](const auto& core) { return core.param; });

INSTANTIATE_TEST_SUITE_P(Laws, EveryCore, testing::ValuesIn(builtins().filters.names()),
                         [](const auto& core) { return core.param; });

}  // namespace
}  // namespace adaptive_localization
