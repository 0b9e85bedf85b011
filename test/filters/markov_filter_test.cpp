// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/filters/markov_filter.hpp"

#include <gmock/gmock.h>

#include <map>

#include "adaptive_localization/filters/builtins.hpp"
#include "support/pose_matchers.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::unique_ptr<Filter> makeMarkov(const std::map<std::string, OptionValue>& options = {}) {
  FilterContext context{builtins(), asymmetricWorld()};
  for (const auto& [key, value] : options) context.parameters.set(key, value);
  return builtins().filters.make("markov", context);
}

TEST(MarkovFilter, FindsARobotAnywhereAndKnowsHowWellItKnows) {
  const auto filter = makeMarkov();
  filter->reset(Anywhere{});
  EXPECT_GT(filter->estimate().covariance.trace(), 1.0);
  Estimate estimate;
  const auto drive = toyDrive(asymmetricWorld(), 4);
  for (const ToyStep& step : drive) estimate = filter->update(step.motion, step.observations);
  EXPECT_THAT(estimate.T_map_base, PoseNear(drive.back().T_map_base, 0.08, 0.05));
  EXPECT_GT(estimate.modes.front().mass, 0.99);
  const double variance = estimate.covariance(0, 0) + estimate.covariance(1, 1);
  EXPECT_LT(variance, 0.02);
  EXPECT_GT(variance, 0.1 * 0.1 / 6.0);
}

/// Whether it finds a robot that was carried to the other end while it drove.
bool findsOneThatWasCarried(double anywhere) {
  const auto filter = makeMarkov({{"markov_anywhere", anywhere}, {"markov_cell", 0.2}});
  const auto drive = toyDrive(asymmetricWorld(), 4);
  filter->reset(Gaussian2{{8.0, 3.5, 2.0}, Eigen::Matrix3d(0.01 * Eigen::Matrix3d::Identity())});
  Estimate estimate;
  for (const ToyStep& step : drive) estimate = filter->update(step.motion, step.observations);
  return distance(estimate.T_map_base, drive.back().T_map_base) < 0.15;
}

TEST(MarkovFilter, FindsARobotThatWasCarriedAwayIfItMayBeAnywhere) {
  EXPECT_TRUE(findsOneThatWasCarried(1e-3));
  EXPECT_FALSE(findsOneThatWasCarried(0.0));
}

TEST(MarkovFilter, ShowsAsManyParticlesAsItIsTold) {
  const auto filter = makeMarkov({{"cloud_particles", 77}});
  filter->reset(Anywhere{});
  EXPECT_EQ(filter->hypotheses().size(), 77);
}

TEST(MarkovFilter, RefusesMapsWhoseBeliefIsTooLargeAndNamesThePrice) {
  const Lattice lattice(1980, 1980, 0.05, {});
  OccupancyGrid hall(lattice, std::vector<std::int8_t>(lattice.size(), OccupancyGrid::kFree));
  MarkovOptions options;
  try {
    checkPriceOfCells(options, hall, 60, 1.0);
    FAIL() << "was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("'markov_cell': got '0.1'"), HasSubstr("9e+07 cells"),
                                    HasSubstr("5400 MB"), HasSubstr("markov_max_memory, 1000 MB")));
  }
  options.markov_max_memory = 6000.0;
  EXPECT_THROW(checkPriceOfCells(options, hall, 60, 1.0), std::invalid_argument);  // look-ups
  EXPECT_NO_THROW(checkPriceOfCells(options, hall, 30, 1.0));
  options.markov_max_memory = 1000.0;
  options.markov_cell = 0.25;
  EXPECT_NO_THROW(checkPriceOfCells(options, hall, 60, 1.0));
}

TEST(MarkovFilter, GivesHitsTheDeviationThatAPoseHasWithinItsCell) {
  MarkovOptions options;
  EXPECT_NEAR(sigmaInCells(0.04, options), std::sqrt(0.0016 + 0.01 / 12.0 + 0.0439 / 12.0), 1e-4);
  options.markov_headings = 1000000;
  options.markov_cell = 0.0;
  EXPECT_NEAR(sigmaInCells(0.04, options), 0.04, 1e-6);
}

}  // namespace
}  // namespace adaptive_localization
