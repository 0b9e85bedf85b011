// SPDX-License-Identifier: BSD-3-Clause
// What each core makes of the same drive with the same seed: the same today as yesterday, with any
// compiler. Where a change is meant, copy the rows that the test prints.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <ostream>

#include "adaptive_localization/filter_registry.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

/// Where a core believes the robot to be: sums over the steps of a drive.
struct Golden {
  const char* name;
  double x, y, theta, trace;  // m, m, rad, m^2 + rad^2
  long hypotheses;
};

constexpr Golden kGolden[] = {
    {"amcl", 239.116006553, 111.354745635, 43.978912872, 0.080826875, 30500},
    {"ba", 239.252860382, 111.389389944, 50.261159143, 0.076905139, 24400},
    {"ekf_icp", 239.262832389, 111.389540335, 50.262443233, 0.076892799, 12200},
    {"kld", 239.116006553, 111.354745635, 43.978912872, 0.080826875, 30500},
    {"lbba", 239.252859413, 111.389393193, 50.261167060, 0.076904991, 24400},
    {"mcl", 239.119192254, 111.348626116, 43.985669520, 0.080303738, 30500},
    {"pso", 239.252859166, 111.389392737, 50.261165793, 0.076905014, 24400},
    {"sa_kld", 239.116006553, 111.354745635, 43.978912872, 0.080826875, 30500},
    {"samcl", 239.119192254, 111.348626116, 43.985669520, 0.080303738, 30500},
};

std::unique_ptr<Filter> makeFilter(const std::string& name) {
  const FilterRegistry registry;
  const FilterDescription& description = registry.find(name);
  FilterContext context;
  context.map = asymmetricWorld();
  context.distance_field = std::make_shared<const DistanceField>(*context.map);
  context.seed = 7;
  for (const auto& [key, value] : description.recommended) context.parameters.set(key, value);
  context.parameters.set("max_particles", OptionValue{500});
  return description.make(context);
}

Golden driveWith(const std::string& name) {
  const auto filter = makeFilter(name);
  const auto drive = toyDrive(asymmetricWorld(), 3);
  filter->reset(
      Gaussian2{drive.front().T_map_base, Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal()});
  Golden golden{"", 0.0, 0.0, 0.0, 0.0, 0};
  for (const ToyStep& step : drive) {
    const Estimate estimate = filter->update(step.motion, step.observations);
    golden.x += estimate.T_map_base.x;
    golden.y += estimate.T_map_base.y;
    golden.theta += estimate.T_map_base.theta;
    golden.trace += estimate.covariance.trace();
    golden.hypotheses += static_cast<long>(filter->hypotheses().size());
  }
  return golden;
}

void PrintTo(const Golden& golden, std::ostream* os) {
  *os << golden.name;
}

class GoldenCores : public testing::TestWithParam<Golden> {};

TEST_P(GoldenCores, BelieveWhatTheyBelieved) {
  const Golden& before = GetParam();
  const Golden now = driveWith(before.name);
  char row[200];
  std::snprintf(row, sizeof row, "    {\"%s\", %.9f, %.9f, %.9f, %.9f, %ld},", before.name, now.x,
                now.y, now.theta, now.trace, now.hypotheses);
  SCOPED_TRACE(row);
  EXPECT_NEAR(now.x, before.x, 1e-6);
  EXPECT_NEAR(now.y, before.y, 1e-6);
  EXPECT_NEAR(now.theta, before.theta, 1e-6);
  EXPECT_NEAR(now.trace, before.trace, 1e-6);
  EXPECT_EQ(now.hypotheses, before.hypotheses);
  const Golden again = driveWith(before.name);
  EXPECT_EQ(again.x, now.x);
  EXPECT_EQ(again.trace, now.trace);
}

INSTANTIATE_TEST_SUITE_P(Names, GoldenCores, testing::ValuesIn(kGolden),
                         [](const auto& about) { return std::string(about.param.name); });

TEST(GoldenCores, AreAllBuiltInOnes) {
  std::vector<std::string> names;
  for (const Golden& golden : kGolden) names.push_back(golden.name);
  EXPECT_EQ(names, FilterRegistry().names());
}

}  // namespace
}  // namespace adaptive_localization
