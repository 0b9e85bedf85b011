// SPDX-License-Identifier: BSD-3-Clause
// A localizer with any core, through any calls with any numbers: its answers are numbers.
#include "adaptive_localization/localizer/localizer.hpp"

#include <fuzzer/FuzzedDataProvider.h>

#include "fuzz/input_file.hpp"
#include "support/toy_world.hpp"

namespace al = adaptive_localization;

namespace {

std::shared_ptr<const al::OccupancyGrid> map() {
  static const auto world = al::toyWorld({"############",  //
                                          "#....#.....#",  //
                                          "#..........#",  //
                                          "#.##...#####",  //
                                          "############"},
                                         0.25, {-1.0, 2.0, 0.3}, 2);
  return world;
}

double number(FuzzedDataProvider& given, double low, double high) {
  return given.ConsumeIntegralInRange(0, 15) > 0 ? given.ConsumeFloatingPointInRange(low, high)
                                                 : given.ConsumeFloatingPoint<double>();
}

al::Pose2 pose(FuzzedDataProvider& given, double size) {
  return {number(given, -size, size), number(given, -size, size), number(given, -4.0, 4.0)};
}

al::Parameters parameters(FuzzedDataProvider& given) {
  al::Parameters chosen;
  for (const auto& [key, value] : std::map<std::string, al::OptionValue>{
           {"filter", given.PickValueInArray<std::string>({"mcl", "kld", "amcl", "samcl", "sa_kld",
                                                           "lbba", "ba", "pso", "ekf_icp"})},
           {"preset", std::string(given.ConsumeBool() ? "seed" : "recommended")},
           {"threads", 1},
           {"recovery", given.ConsumeBool()},
           {"refine", given.ConsumeBool()},
           {"min_particles", 10},
           {"max_particles", 60},
           {"swarm_size", 20},
           {"laser_max_beams", 20}}) {
    chosen.set(key, value);
  }
  return chosen;
}

al::Observations seen(FuzzedDataProvider& given, const al::ScanOptions& options, double stamp) {
  al::LaserScan scan = al::ToyLaser{31, -2.0, 2.0, 12.0}.read(map(), pose(given, 3.0));
  const std::size_t changed = given.ConsumeIntegralInRange<std::size_t>(0, 8);
  for (std::size_t i = 0; i < changed; ++i) {
    scan.ranges[given.ConsumeIntegralInRange<std::size_t>(0, scan.ranges.size() - 1)] =
        given.ConsumeFloatingPoint<float>();
  }
  scan.stamp = stamp;
  return {stamp, al::toScan(scan, al::LaserMount{}, options)};
}

void checkNumbers(const al::Localization& answer) {
  const bool are_numbers = al::isFinite(answer.T_map_base) && al::isFinite(answer.T_map_odom) &&
                           answer.covariance.allFinite() && answer.confidence >= 0.0 &&
                           answer.confidence <= 1.0;
  if (!are_numbers) std::abort();
}

void call(FuzzedDataProvider& given, al::Localizer& localizer, al::Pose2& T_odom_base,
          double stamp) {
  switch (given.ConsumeIntegralInRange(0, 9)) {
    case 0:
      return localizer.reset(al::Anywhere{});
    case 1: {
      const Eigen::Vector3d variance(number(given, 0.0, 1.0), number(given, 0.0, 1.0),
                                     number(given, 0.0, 1.0));
      return localizer.reset(al::Gaussian2{pose(given, 3.0), variance.asDiagonal()});
    }
    case 2:
      return localizer.configure(parameters(given));
    case 3:
      return localizer.setMap(al::Ground(map()));
    case 4:
      return localizer.requestUpdate();
    default: {
      const al::Pose2 moved = T_odom_base * pose(given, 0.3);
      if (al::isPlace(moved)) T_odom_base = moved;
      checkNumbers(localizer.update(moved, seen(given, localizer.scanOptions(), stamp)));
      return localizer.searchOn();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider given(data, size);
  al::Localizer localizer(parameters(given), al::Ground(map()));
  al::Pose2 T_odom_base;
  for (double stamp = 0.1; given.remaining_bytes() > 0 && stamp < 3.0; stamp += 0.1) {
    al::tryToRead([&] { call(given, localizer, T_odom_base, stamp); });
  }
  return 0;
}
