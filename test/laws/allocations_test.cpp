// SPDX-License-Identifier: BSD-3-Clause
// How often an update allocates memory while the robot is tracked: some dozen times, however many
// particles there are, and it keeps none of it.
#include "support/allocations.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <set>
#include <string>

#include "adaptive_localization/filters/builtins.hpp"
#include "adaptive_localization/localizer/localizer.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

struct Counts {
  double taken;  // per update
  long kept;     // in all
};

/// Allocations in the second half of a drive.
Counts countOf(const std::string& filter, int particles) {
  using allocations::given_back;
  using allocations::taken;
  const auto map = asymmetricWorld();
  const std::vector<ToyStep> drive = toyDrive(map, 1, 61);
  Parameters parameters;
  parameters.set("filter", filter);
  parameters.set("min_particles", particles);
  parameters.set("max_particles", particles);
  parameters.set("threads", 1);
  Localizer localizer(parameters, Ground(map));
  localizer.reset(Gaussian2{drive.front().T_map_base, 0.001 * Eigen::Matrix3d::Identity()});
  Pose2 T_odom_base;
  const std::size_t half = drive.size() / 2;
  long taken_before = 0, kept_before = 0;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    T_odom_base = T_odom_base * drive[i].motion;
    if (i == half) {
      taken_before = taken;
      kept_before = taken - given_back;
    }
    localizer.update(T_odom_base, drive[i].observations);
  }
  const long kept = taken - given_back - kept_before;
  const auto updates = static_cast<double>(drive.size() - half);
  return {static_cast<double>(taken - taken_before) / updates, kept};
}

class EveryCore : public testing::TestWithParam<std::string> {};

/// Swarms and histograms allocate more.
TEST_P(EveryCore, AllocatesAsOftenForManyParticlesAsForFew) {
  const std::set<std::string> slow{"ba", "lbba", "pso", "markov"};
  const Counts few = countOf(GetParam(), 500);
  const Counts many = countOf(GetParam(), 8000);
  EXPECT_GT(few.taken, 0.0) << "nothing is counted";
  EXPECT_LT(few.taken, slow.count(GetParam()) > 0 ? 350.0 : 100.0);
  EXPECT_LT(many.taken, few.taken + 5.0);
  EXPECT_LT(std::abs(few.kept), 20);
  EXPECT_LT(std::abs(many.kept), 20);
  RecordProperty("per_update", std::to_string(few.taken));
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryCore, testing::ValuesIn(builtins().filters.names()),
                         [](const auto& core) { return core.param; });

}  // namespace
}  // namespace adaptive_localization
