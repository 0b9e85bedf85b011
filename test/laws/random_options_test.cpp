// SPDX-License-Identifier: BSD-3-Clause
// Whatever options within their ranges make a core, and whatever scans and odometry it is given:
// its answers are numbers, and it costs what its sizes say.
#include <gmock/gmock.h>

#include <cmath>

#include "adaptive_localization/localizer/localizer.hpp"
#include "support/pose_matchers.hpp"
#include "support/temp_folder.hpp"
#include "support/toy_world.hpp"

namespace adaptive_localization {
namespace {

using Values = std::map<std::string, OptionValue>;
using Case = std::tuple<std::string, std::string>;  // filter, preset

constexpr std::uint64_t kSeeds = 40;
constexpr int kMostParticles = 300;
constexpr int kMostHypotheses = 10 * kMostParticles;  // ekf_icp has so many anywhere
constexpr int kMostBeams = 100;
constexpr int kMostVisits = 100000;

/// What makes a call slow, and nothing else: less of it.
const std::map<std::string, double> kSizes{{"min_particles", 50},
                                           {"max_particles", kMostParticles},
                                           {"swarm_size", kMostParticles},
                                           {"cloud_particles", kMostParticles},
                                           {"laser_max_beams", kMostBeams},
                                           {"swarm_beams", kMostBeams},
                                           {"swarm_budget", 0.3},
                                           {"swarm_max_iterations", 300},
                                           {"match_max_iterations", 100},
                                           {"search_max_places", 20},
                                           {"search_max_visits", kMostVisits},
                                           {"markov_headings", 72},
                                           {"threads", 1}};
const std::map<std::string, double> kLeast{{"markov_cell", 0.2}, {"markov_max_memory", 1000.0}};

std::shared_ptr<const OccupancyGrid> smallWorld() {
  static const auto map = toyWorld({"####################",  //
                                    "#........#.........#",  //
                                    "#........#...####..#",  //
                                    "#...##.............#",  //
                                    "#...##......########",  //
                                    "#..................#",  //
                                    "####################"},
                                   0.25, {-1.0, 2.0, 0.3}, 2);
  return map;
}

/// Reflectors, which any intensity may be, are looked for among them.
std::string landmarkFile() {
  static const TempFolder folder;
  static const std::string file =
      folder.write("posts.yaml", "landmarks: [{id: 0, at: [1.0, 4.0]}]\n");
  return file;
}

/// Log-uniform over the range, its ends and 0 among the values now and then.
double numberIn(const Range& range, Rng& rng) {
  const double high = std::min(range.high, 1e300);
  const double low = std::max(range.low, -high);
  const double kind = rng.uniform();
  if (kind < 0.1) return low;
  if (kind < 0.2) return high;
  const double smallest = low > 0.0 ? low : std::min(1e-12, high);
  const double size = std::exp(rng.uniform(std::log(smallest), std::log(high)));
  return std::clamp(low < 0.0 && kind < 0.6 ? -size : size, low, high);
}

/// None for paths and names, which stay as they are.
std::optional<OptionValue> randomValue(const OptionDescription& option, Rng& rng) {
  Range range = option.range;
  const auto size = kSizes.find(option.key);
  if (size != kSizes.end()) range.high = std::min(range.high, size->second);
  if (const auto least = kLeast.find(option.key); least != kLeast.end()) range.low = least->second;
  if (std::holds_alternative<bool>(option.value)) return rng.uniform() < 0.5;
  if (std::holds_alternative<double>(option.value)) return numberIn(range, rng);
  if (std::holds_alternative<int>(option.value)) {
    range.high = std::min(range.high, 2147483647.0);
    return static_cast<int>(numberIn(range, rng));
  }
  if (option.choices.empty()) return std::nullopt;
  return option.choices[rng.below(option.choices.size())];
}

/// The first must not be above the second.
const std::vector<std::pair<std::string, std::string>> kOrdered{
    {"min_particles", "max_particles"},
    {"match_reach_end", "match_reach"},
    {"confidence_low_inliers", "confidence_high_inliers"}};

void order(const std::vector<OptionDescription>& options, Values& values) {
  const auto valueOf = [&](const std::string& key) {
    const auto at = std::find_if(options.begin(), options.end(),
                                 [&](const OptionDescription& o) { return o.key == key; });
    if (at == options.end()) return std::nan("");
    const OptionValue& value = values.count(key) ? values.at(key) : at->value;
    return std::stod(toText(value));
  };
  for (const auto& [low, high] : kOrdered) {
    if (!(valueOf(low) >= valueOf(high))) continue;
    values.erase(low);
    values.erase(high);
    if (!kSizes.count(high)) continue;
    values[low] = 50;
    values[high] = kMostParticles;
  }
}

/// A third of the options at random, or one alone.
Parameters randomParameters(const Case& which, Rng& rng) {
  Parameters parameters;
  parameters.set("filter", OptionValue{std::get<0>(which)});
  parameters.set("preset", OptionValue{std::get<1>(which)});
  const auto options = Localizer(parameters, smallWorld()).effectiveOptions();
  const std::size_t single = rng.uniform() < 0.3 ? rng.below(options.size()) : options.size();
  Values values;
  for (std::size_t i = 0; i < options.size(); ++i) {
    const bool is_changed = single < options.size() ? i == single : rng.uniform() < 0.33;
    if (!is_changed && !kSizes.count(options[i].key) && !kLeast.count(options[i].key)) continue;
    if (const auto value = randomValue(options[i], rng)) values[options[i].key] = *value;
  }
  order(options, values);
  values.erase("preset");
  values["ekf_landmarks"] = std::string("hits");  // lines need a plan
  values["landmark_map"] = landmarkFile();
  if (values.count("swarm_ranges")) values["swarm_ranges"] = std::string("cast");
  for (const auto& [key, value] : values) parameters.set(key, value);
  return parameters;
}

float randomRange(Rng& rng, int kind) {
  const float odd[] = {0.0F, -1.0F, 1e-6F, 1e6F, INFINITY, -INFINITY, NAN, 1e38F};
  if (kind == 0) return NAN;
  if (kind == 1) return INFINITY;
  if (kind == 2) return 1e-3F;
  if (kind == 3 && rng.uniform() < 0.5) return odd[rng.below(8)];
  return static_cast<float>(rng.uniform(0.05, 8.0));
}

/// Of a place in the map, or of nothing there is: hits at random, none, one beam, tiny, huge.
Observations randomScan(const ScanOptions& options, double stamp, Rng& rng) {
  LaserScan scan = ToyLaser{rng.uniform() < 0.1 ? 2 : 61, -2.0, 2.0, 12.0}.read(
      smallWorld(), {rng.uniform(0.0, 5.0), rng.uniform(3.0, 5.0), rng.uniform(-kPi, kPi)});
  const auto kind = static_cast<int>(rng.below(8));
  if (kind < 5) {
    for (float& range : scan.ranges) range = randomRange(rng, kind);
  }
  if (kind == 5) scan.ranges.resize(1);
  if (kind == 6) scan.range_max = 1e6;
  if (rng.uniform() < 0.1) return {stamp, Scan{}};
  scan.stamp = stamp;
  return {stamp, toScan(scan, LaserMount{}, options)};
}

Pose2 randomMotion(Rng& rng) {
  const double kind = rng.uniform();
  const double size = kind < 0.6 ? 0.2 : kind < 0.8 ? 0.0 : std::pow(10.0, rng.uniform(-9.0, 9.0));
  return randomPose(rng, size);
}

Prior randomPrior(Rng& rng) {
  if (rng.uniform() < 0.4) return Anywhere{};
  Gaussian2 prior{{rng.uniform(0.0, 5.0), rng.uniform(3.0, 5.0), rng.uniform(-kPi, kPi)}, {}};
  prior.covariance.setZero();
  for (int i = 0; i < 3; ++i) prior.covariance(i, i) = numberIn({0.0, 1e6}, rng);
  return prior;
}

void expectNumbers(const Particles& cloud) {
  for (const auto* column : {&cloud.x, &cloud.y, &cloud.theta}) ASSERT_TRUE(column->allFinite());
  ASSERT_FALSE(cloud.log_weight.isNaN().any());
}

void expectNumbers(const Localizer& localizer, const Localization& answer) {
  ASSERT_TRUE(isFinite(answer.T_map_base) && isFinite(answer.T_map_odom));
  ASSERT_THAT(answer.estimate, IsSaneEstimate());
  ASSERT_TRUE(answer.confidence >= 0.0 && answer.confidence <= 1.0) << answer.confidence;
  for (const Mode& mode : answer.modes) {
    ASSERT_TRUE(isFinite(mode.T_map_base) && mode.covariance.allFinite());
    ASSERT_TRUE(mode.mass >= 0.0 && mode.mass <= 1.0 + 1e-9) << mode.mass;
  }
  expectNumbers(localizer.hypotheses());
  expectNumbers(localizer.leaders());
}

std::string textOf(const Parameters& parameters) {
  std::string text;
  for (const auto& [key, value] : parameters.values()) text += key + ": " + toText(value) + "\n";
  return text;
}

class EveryCore : public testing::TestWithParam<Case> {};

TEST_P(EveryCore, GivesNumbersForAnyOptionsInRange) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Rng rng(seed);
    const Parameters parameters = randomParameters(GetParam(), rng);
    Localizer localizer(parameters, smallWorld());
    localizer.reset(randomPrior(rng));
    Pose2 T_odom_base;
    for (int step = 0; step < 8; ++step) {
      T_odom_base = T_odom_base * randomMotion(rng);
      const auto seen = randomScan(localizer.scanOptions(), 0.1 * step, rng);
      const Localization answer = localizer.update(T_odom_base, seen);
      expectNumbers(localizer, answer);
      EXPECT_LE(localizer.hypotheses().size(), kMostHypotheses);
      EXPECT_LE(seen.scan.range.size() + seen.scan.no_return_bearing.size(), kMostBeams);
      if (HasFailure()) {
        FAIL() << "seed " << seed << ", step " << step << "\n" << textOf(parameters);
      }
    }
  }
}

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  return std::get<0>(info.param) + "_" + std::get<1>(info.param);
}
INSTANTIATE_TEST_SUITE_P(Cores, EveryCore,
                         testing::Combine(testing::ValuesIn(builtins().filters.names()),
                                          testing::Values("recommended", "seed")),
                         nameOf);

}  // namespace
}  // namespace adaptive_localization
