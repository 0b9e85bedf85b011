// SPDX-License-Identifier: BSD-3-Clause
// What each core makes of the same drive with the same seed: the same today as yesterday, with any
// compiler; swarms also when nobody told them where it starts, and with their sources' preset.
// Where a change is meant, copy the rows that the test prints.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "adaptive_localization/filter_registry.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

/// Where a core believes the robot to be: sums over the steps of a drive.
struct Golden {
  const char* name;
  const char* preset;
  bool is_told;               // where it starts
  double x, y, theta, trace;  // m, m, rad, m^2 + rad^2
  long hypotheses, leaders;
};

constexpr Golden kGolden[] = {
    {"amcl", "recommended", true, 239.116006553, 111.354745635, 43.978912872, 0.080826875, 30500,
     0},
    {"ba", "recommended", true, 239.252860382, 111.389389944, 50.261159143, 0.076905139, 24400, 0},
    {"ekf_icp", "recommended", true, 239.262832389, 111.389540335, 50.262443233, 0.076892799, 12200,
     0},
    {"kld", "recommended", true, 239.116006553, 111.354745635, 43.978912872, 0.080826875, 30500, 0},
    {"lbba", "recommended", true, 239.252859413, 111.389393193, 50.261167060, 0.076904991, 24400,
     488},
    {"mcl", "recommended", true, 239.119192254, 111.348626116, 43.985669520, 0.080303738, 30500, 0},
    {"pso", "recommended", true, 239.252859166, 111.389392737, 50.261165793, 0.076905014, 24400, 0},
    {"sa_kld", "recommended", true, 239.116006553, 111.354745635, 43.978912872, 0.080826875, 30500,
     0},
    {"samcl", "recommended", true, 239.119192254, 111.348626116, 43.985669520, 0.080303738, 30500,
     0},
    {"ba", "recommended", false, 239.255850089, 111.388230726, 50.262292808, 0.076777667, 24400, 0},
    {"lbba", "recommended", false, 239.255893397, 111.388213875, 50.262395951, 0.076730901, 24400,
     488},
    {"pso", "recommended", false, 239.255830930, 111.388234785, 50.262293630, 0.076786594, 24400,
     0},
    {"ba", "seed", true, 239.629405577, 111.477438899, 63.192832786, 2.807431415, 122000, 0},
    {"lbba", "seed", true, 239.501062501, 111.072370147, 25.652925037, 2.896338017, 122000, 366},
    {"pso", "seed", true, 239.684857675, 111.247635633, 50.717323562, 2.338572239, 122000, 0},
    {"lbba", "seed", false, 243.237656096, 111.324489842, -12.165266695, 2.282039820, 122000, 366},
};

std::unique_ptr<Filter> makeFilter(const Golden& golden) {
  const FilterRegistry registry;
  const FilterDescription& description = registry.find(golden.name);
  FilterContext context;
  context.map = asymmetricWorld();
  context.distance_field = std::make_shared<const DistanceField>(*context.map);
  context.seed = 7;
  const bool is_seed = std::string(golden.preset) == "seed";
  for (const auto& [key, value] : is_seed ? description.seed : description.recommended) {
    context.parameters.set(key, value);
  }
  context.parameters.set("max_particles", OptionValue{500});
  return description.make(context);
}

Golden driveAgain(const Golden& before) {
  const auto filter = makeFilter(before);
  const auto drive = toyDrive(asymmetricWorld(), 3);
  const Gaussian2 start{drive.front().T_map_base, Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal()};
  filter->reset(before.is_told ? Prior{start} : Prior{Anywhere{}});
  Golden now{before.name, before.preset, before.is_told, 0.0, 0.0, 0.0, 0.0, 0, 0};
  for (const ToyStep& step : drive) {
    const Estimate estimate = filter->update(step.motion, step.observations);
    now.x += estimate.T_map_base.x;
    now.y += estimate.T_map_base.y;
    now.theta += estimate.T_map_base.theta;
    now.trace += estimate.covariance.trace();
    now.hypotheses += static_cast<long>(filter->hypotheses().size());
    now.leaders += static_cast<long>(filter->leaders().size());
  }
  return now;
}

std::string nameOf(const Golden& golden) {
  return std::string(golden.name) + "_" + golden.preset + (golden.is_told ? "_told" : "_anywhere");
}

void PrintTo(const Golden& golden, std::ostream* os) {
  *os << nameOf(golden);
}

class GoldenCores : public testing::TestWithParam<Golden> {};

TEST_P(GoldenCores, BelieveWhatTheyBelieved) {
  const Golden& before = GetParam();
  const Golden now = driveAgain(before);
  char row[200];
  std::snprintf(row, sizeof row, "    {\"%s\", \"%s\", %s, %.9f, %.9f, %.9f, %.9f, %ld, %ld},",
                now.name, now.preset, now.is_told ? "true" : "false", now.x, now.y, now.theta,
                now.trace, now.hypotheses, now.leaders);
  SCOPED_TRACE(row);
  EXPECT_NEAR(now.x, before.x, 1e-6);
  EXPECT_NEAR(now.y, before.y, 1e-6);
  EXPECT_NEAR(now.theta, before.theta, 1e-6);
  EXPECT_NEAR(now.trace, before.trace, 1e-6);
  EXPECT_EQ(now.hypotheses, before.hypotheses);
  EXPECT_EQ(now.leaders, before.leaders);
  const Golden again = driveAgain(before);
  EXPECT_EQ(again.x, now.x);
  EXPECT_EQ(again.trace, now.trace);
}

INSTANTIATE_TEST_SUITE_P(Names, GoldenCores, testing::ValuesIn(kGolden),
                         [](const auto& about) { return nameOf(about.param); });

TEST(GoldenCores, AreAllBuiltInOnes) {
  std::set<std::string> names;
  for (const Golden& golden : kGolden) names.insert(golden.name);
  const std::vector<std::string> built_in = FilterRegistry().names();
  EXPECT_EQ(names, std::set<std::string>(built_in.begin(), built_in.end()));
}

}  // namespace
}  // namespace adaptive_localization
