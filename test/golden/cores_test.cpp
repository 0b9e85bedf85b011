// SPDX-License-Identifier: BSD-3-Clause
// What the localizer makes of the same drive with the same seed, for each core, preset and start:
// the same today as yesterday, with any compiler. Presets named "seed" run the literature's core
// alone. Where a change is meant, copy the rows that the test prints.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "adaptive_localization/localizer/localizer.hpp"
#include "support/toy_drive.hpp"

namespace adaptive_localization {
namespace {

/// Sums over the scans of a drive: estimates, covariances, sizes of the cloud, scans said to be
/// tracked.
struct Golden {
  const char* name;
  const char* preset;
  const char* start;          // told, anywhere, or kidnapped: told, and carried away on the way
  double x, y, theta, trace;  // m, m, rad, m^2 + rad^2
  long hypotheses, leaders, tracked;
};

constexpr Golden kGolden[] = {
    {"amcl", "recommended", "told", 239.260356356, 111.384033036, 50.262712070, 0.077158456, 30500,
     0, 61},
    {"amcl", "recommended", "anywhere", 239.258130752, 111.383607059, 50.262415554, 0.076900672,
     30500, 0, 61},
    {"amcl", "recommended", "kidnapped", 114.773748057, 70.183882858, 21.383410699, 0.072601380,
     19500, 0, 33},
    {"amcl", "seed", "told", 239.854507817, 111.017555001, 2.415117297, 1.446221433, 29388, 0, 61},
    {"amcl", "seed", "anywhere", 405.971484817, 114.396693265, 2.255855319, 10.390618459, 30500, 0,
     0},
    {"amcl", "seed", "kidnapped", 129.583540515, 56.571415777, 20.766743263, 1.286223154, 18000, 0,
     15},
    {"ba", "recommended", "told", 239.245091483, 111.382498761, 50.259310388, 0.077161822, 24400, 0,
     61},
    {"ba", "recommended", "anywhere", 239.237467423, 111.383820538, 50.257228741, 0.076202503,
     24400, 0, 61},
    {"ba", "recommended", "kidnapped", 114.758163216, 70.181613978, 21.443715955, 0.072525100,
     16000, 0, 33},
    {"ba", "seed", "told", 240.194146340, 111.580251756, 87.698716245, 2.819075856, 122000, 0, 61},
    {"ba", "seed", "anywhere", 238.940763236, 111.204133520, 87.733787078, 2.413715524, 122000, 0,
     61},
    {"ba", "seed", "kidnapped", 117.865361117, 73.847077115, 62.757989677, 1.812209571, 72000, 0,
     35},
    {"ekf_icp", "recommended", "told", 239.256538562, 111.384090969, 50.261830523, 0.077322102,
     12200, 0, 61},
    {"ekf_icp", "recommended", "anywhere", 243.115646618, 112.839728908, 50.561445012, 11.376303560,
     14000, 0, 59},
    {"ekf_icp", "recommended", "kidnapped", 114.772334272, 70.183683862, 21.446559404, 0.072620660,
     7200, 0, 33},
    {"ekf_icp", "seed", "told", 239.284003914, 111.391657905, 50.272112102, 0.069115034, 12200, 0,
     61},
    {"ekf_icp", "seed", "anywhere", 239.281933454, 111.394999636, 50.270909359, 0.068175606, 12200,
     0, 61},
    {"ekf_icp", "seed", "kidnapped", 129.508155328, 54.889444713, 15.480918606, 0.380179592, 7200,
     0, 15},
    {"kld", "recommended", "told", 239.260356356, 111.384033036, 50.262712070, 0.077158456, 30500,
     0, 61},
    {"kld", "recommended", "anywhere", 265.845871658, 117.567257227, 49.848019472, 0.844659863,
     30500, 0, 54},
    {"kld", "recommended", "kidnapped", 132.302132882, 57.244216422, 19.835482920, 0.244696908,
     18000, 0, 15},
    {"kld", "seed", "told", 239.419380170, 111.379804021, 25.233151648, 0.246348764, 13905, 0, 61},
    {"kld", "seed", "anywhere", 381.252610349, 185.410404828, -83.000176866, 11.083571150, 30200, 0,
     0},
    {"kld", "seed", "kidnapped", 127.028683168, 57.658512931, 21.320889138, 0.504740237, 11814, 0,
     15},
    {"lbba", "recommended", "told", 239.246140778, 111.383075078, 50.259507653, 0.076201651, 24400,
     488, 61},
    {"lbba", "recommended", "anywhere", 239.234084805, 111.387555639, 50.254223731, 0.076223801,
     24400, 488, 61},
    {"lbba", "recommended", "kidnapped", 114.764176498, 70.183280956, 21.444474730, 0.071500791,
     16000, 280, 33},
    {"lbba", "seed", "told", 240.194146340, 111.580251756, 87.698716245, 2.819075856, 122000, 366,
     61},
    {"lbba", "seed", "anywhere", 240.367767876, 111.114821021, 25.311554812, 2.536518575, 122000,
     366, 61},
    {"lbba", "seed", "kidnapped", 117.693008922, 73.748520961, 63.039698658, 1.658382309, 72000,
     216, 35},
    {"markov", "recommended", "told", 239.252446068, 111.385306356, 50.260466508, 0.076559822,
     30500, 0, 61},
    {"markov", "recommended", "anywhere", 239.252667347, 111.385265185, 50.260523866, 0.076568843,
     30500, 0, 61},
    {"markov", "recommended", "kidnapped", 114.860800993, 70.199550405, 21.278981577, 0.092447322,
     18000, 0, 33},
    {"markov", "seed", "told", 239.702685603, 111.436775608, 68.874202027, 0.253098759, 30500, 0,
     61},
    {"markov", "seed", "anywhere", 238.983376512, 111.718755082, -5.847538307, 0.438196475, 30500,
     0, 61},
    {"markov", "seed", "kidnapped", 126.093987419, 44.502906367, 23.049021499, 0.887523592, 18000,
     0, 15},
    {"mcl", "recommended", "told", 239.260356356, 111.384033036, 50.262712070, 0.077158456, 30500,
     0, 61},
    {"mcl", "recommended", "anywhere", 259.985500712, 117.303553671, 50.156514576, 0.743513673,
     30500, 0, 55},
    {"mcl", "recommended", "kidnapped", 132.704547002, 57.455872111, 19.993601666, 0.245869060,
     18000, 0, 15},
    {"mcl", "seed", "told", 239.446101958, 111.418179483, 31.482117017, 0.246580528, 30500, 0, 61},
    {"mcl", "seed", "anywhere", 381.243671656, 185.592594158, -82.815502218, 11.161942991, 30500, 0,
     0},
    {"mcl", "seed", "kidnapped", 127.062686486, 57.733384346, 21.255362768, 0.526478350, 18000, 0,
     15},
    {"pso", "recommended", "told", 239.246171704, 111.382682668, 50.259803783, 0.076181294, 24400,
     0, 61},
    {"pso", "recommended", "anywhere", 239.233236214, 111.384026498, 50.255662739, 0.076272146,
     24400, 0, 61},
    {"pso", "recommended", "kidnapped", 114.762817690, 70.183398250, 21.443457188, 0.071569625,
     16000, 0, 33},
    {"pso", "seed", "told", 240.194146340, 111.580251756, 87.698716245, 2.819075856, 122000, 0, 61},
    {"pso", "seed", "anywhere", 239.384850910, 111.069872354, 24.869412765, 2.599609627, 122000, 0,
     61},
    {"pso", "seed", "kidnapped", 118.015241751, 73.690527554, 19.222278659, 1.746075155, 72000, 0,
     35},
    {"sa_kld", "recommended", "told", 239.260356356, 111.384033036, 50.262712070, 0.077158456,
     30500, 0, 61},
    {"sa_kld", "recommended", "anywhere", 239.258130752, 111.383607059, 50.262415554, 0.076900672,
     30500, 0, 61},
    {"sa_kld", "recommended", "kidnapped", 114.773748057, 70.183882858, 21.383410699, 0.072601380,
     19500, 0, 33},
    {"sa_kld", "seed", "told", 239.419380170, 111.379804021, 25.233151648, 0.246348764, 13905, 0,
     61},
    {"sa_kld", "seed", "anywhere", 242.963160842, 116.357512964, 20.236241702, 15.131963440, 15826,
     0, 53},
    {"sa_kld", "seed", "kidnapped", 113.700483922, 64.550623995, -15.609125122, 0.788198632, 13143,
     0, 23},
    {"samcl", "recommended", "told", 239.260356356, 111.384033036, 50.262712070, 0.077158456, 30500,
     0, 61},
    {"samcl", "recommended", "anywhere", 244.299073692, 112.771700578, 50.143019704, 6.446991334,
     30500, 0, 60},
    {"samcl", "recommended", "kidnapped", 114.814778575, 70.186538858, 21.362488666, 0.072438720,
     19500, 0, 33},
    {"samcl", "seed", "told", 239.446101958, 111.418179483, 31.482117017, 0.246580528, 30500, 0,
     61},
    {"samcl", "seed", "anywhere", 247.091329374, 114.953910581, 37.290814496, 13.334245686, 30500,
     0, 56},
    {"samcl", "seed", "kidnapped", 120.035009522, 57.009791468, 9.715307086, 2.279793371, 18000, 0,
     15},
};

Localizer makeLocalizer(const Golden& golden) {
  Parameters parameters;
  parameters.set("filter", std::string(golden.name));
  parameters.set("preset", std::string(golden.preset));
  parameters.set("seed", 7);
  parameters.set("max_particles", 500);
  return Localizer(parameters, asymmetricWorld());
}

/// A robot that is carried away does not see some of the way, nor does its odometry.
std::vector<ToyStep> driveOf(const std::string& start) {
  std::vector<ToyStep> drive = toyDrive(asymmetricWorld(), 3);
  if (start == "kidnapped") drive.erase(drive.begin() + 15, drive.begin() + 40);
  return drive;
}

Golden driveAgain(const Golden& before) {
  Localizer localizer = makeLocalizer(before);
  const auto drive = driveOf(before.start);
  const Gaussian2 start{drive.front().T_map_base, Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal()};
  localizer.reset(before.start == std::string("anywhere") ? Prior{Anywhere{}} : Prior{start});
  Golden now{before.name, before.preset, before.start, 0.0, 0.0, 0.0, 0.0, 0, 0, 0};
  Pose2 T_odom_base;
  for (const ToyStep& step : drive) {
    T_odom_base = T_odom_base * step.motion;
    const Localization answer = localizer.update(T_odom_base, step.observations);
    now.x += answer.estimate.T_map_base.x;
    now.y += answer.estimate.T_map_base.y;
    now.theta += answer.estimate.T_map_base.theta;
    now.trace += answer.estimate.covariance.trace();
    now.hypotheses += static_cast<long>(localizer.hypotheses().size());
    now.leaders += static_cast<long>(localizer.leaders().size());
    now.tracked += answer.status == Status::kTracking ? 1 : 0;
  }
  return now;
}

std::string nameOf(const Golden& golden) {
  return std::string(golden.name) + "_" + golden.preset + "_" + golden.start;
}

void PrintTo(const Golden& golden, std::ostream* os) {
  *os << nameOf(golden);
}

class GoldenCores : public testing::TestWithParam<Golden> {};

TEST_P(GoldenCores, BelieveWhatTheyBelieved) {
  const Golden& before = GetParam();
  const Golden now = driveAgain(before);
  char row[200];
  std::snprintf(row, sizeof row,
                "    {\"%s\", \"%s\", \"%s\", %.9f, %.9f, %.9f, %.9f, %ld, %ld, %ld},", now.name,
                now.preset, now.start, now.x, now.y, now.theta, now.trace, now.hypotheses,
                now.leaders, now.tracked);
  SCOPED_TRACE(row);
  EXPECT_NEAR(now.x, before.x, 1e-6);
  EXPECT_NEAR(now.y, before.y, 1e-6);
  EXPECT_NEAR(now.theta, before.theta, 1e-6);
  EXPECT_NEAR(now.trace, before.trace, 1e-6);
  EXPECT_EQ(now.hypotheses, before.hypotheses);
  EXPECT_EQ(now.leaders, before.leaders);
  EXPECT_EQ(now.tracked, before.tracked);
  const Golden again = driveAgain(before);
  EXPECT_EQ(again.x, now.x);
  EXPECT_EQ(again.trace, now.trace);
}

INSTANTIATE_TEST_SUITE_P(Names, GoldenCores, testing::ValuesIn(kGolden),
                         [](const auto& about) { return nameOf(about.param); });

TEST(GoldenCores, AreAllBuiltInOnesWithEachPresetAndStart) {
  std::set<std::string> expected, names;
  for (const std::string& name : builtins().filters.names()) {
    for (const std::string preset : {"recommended", "seed"}) {
      for (const std::string start : {"told", "anywhere", "kidnapped"}) {
        expected.insert(name + "_" + preset + "_" + start);
      }
    }
  }
  for (const Golden& golden : kGolden) names.insert(nameOf(golden));
  EXPECT_EQ(names, expected);
}

}  // namespace
}  // namespace adaptive_localization
