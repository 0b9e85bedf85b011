// SPDX-License-Identifier: BSD-3-Clause
#include "builtin_filters.hpp"

#include "particle_filter.hpp"

namespace adaptive_localization {
namespace {

using Preset = std::map<std::string, OptionValue>;

enum class Size { kFixed, kKld };
enum class Elsewhere { kNowhere, kAugmented };

std::unique_ptr<Filter> makeParticleFilter(Size size, Elsewhere elsewhere,
                                           const FilterContext& context) {
  const Parameters& given = context.parameters;
  ParticleFilterParts parts;
  parts.motion = makeMotionModel(given.read<MotionOptions>());
  parts.observation = makeObservationModel(given.read<ObservationOptions>(), context);
  const auto sizes = given.read<SampleSizeOptions>();
  parts.size = size == Size::kKld ? kldSampleSize(sizes) : fixedSampleSize(sizes);
  const auto exploration = given.read<ExplorationOptions>();
  parts.exploration =
      elsewhere == Elsewhere::kAugmented ? augmentedExploration(exploration) : noExploration();
  parts.elsewhere = std::make_unique<FreeSpaceSampler>(context.map);
  return std::make_unique<ParticleFilter>(given.read<ParticleFilterOptions>(), std::move(parts),
                                          context.seed);
}

std::vector<OptionDescription> particleFilterOptions() {
  std::vector<OptionDescription> all;
  const auto append = [&all](const std::vector<OptionDescription>& rows) {
    all.insert(all.end(), rows.begin(), rows.end());
  };
  append(describe(MotionOptions{}));
  append(describe(ObservationOptions{}));
  append(describe(SampleSizeOptions{}));
  append(describe(ExplorationOptions{}));
  append(describe(ParticleFilterOptions{}));
  return all;
}

FilterDescription particleFilter(const std::string& name, const std::string& sentence, Size size,
                                 Elsewhere elsewhere, Preset recommended, Preset seed) {
  const auto make = [size, elsewhere](const FilterContext& context) {
    return makeParticleFilter(size, elsewhere, context);
  };
  return {name, sentence, make, particleFilterOptions(), std::move(recommended), std::move(seed)};
}

/// What the source of mcl, kld and sa_kld used on its Pioneer 3-DX (constant motion noise, 30 beams
/// and ray casting, an update per odometry step), where it differs from our defaults.
Preset source(Preset more) {
  Preset preset{{"odom_alpha1", 0.0},         {"odom_alpha2", 0.0},
                {"odom_alpha3", 0.0},         {"odom_alpha4", 0.0},
                {"odom_noise_xy", 0.020},     {"odom_noise_theta", 0.015},
                {"laser_max_beams", 30},      {"laser_model_type", std::string("inverse_l1")},
                {"laser_max_range", 10.0},    {"update_min_d", 0.0},
                {"update_min_a", 0.0},        {"selective_resampling", false},
                {"min_effective_share", 0.0}, {"laser_sigma_sparse", 0.0}};
  more.insert(preset.begin(), preset.end());
  return more;
}

}  // namespace

std::vector<FilterDescription> builtinFilters() {
  const Preset kld_source{{"min_particles", 200},
                          {"max_particles", 9000},
                          {"kld_err", 0.02},
                          {"kld_bin_xy", 0.3},
                          {"kld_bin_theta", 2.0 * kPi},
                          {"kld_count", std::string("resampled")}};
  const Preset amcl_stock{{"odom_alpha1", 0.2},
                          {"odom_alpha2", 0.2},
                          {"odom_alpha3", 0.2},
                          {"odom_alpha4", 0.2},
                          {"odom_alpha5", 0.2},
                          {"odom_noise_xy", 0.0},
                          {"odom_noise_theta", 0.0},
                          {"laser_model_type", std::string("likelihood_field_cubed")},
                          {"laser_z_rand", 0.05},
                          {"laser_max_beams", 30},
                          {"laser_sigma_hit", 0.2},
                          {"min_particles", 100},
                          {"kld_err", 0.01},
                          {"kld_z", 0.99},
                          {"odom_model_type", std::string("diff")},
                          {"update_min_d", 0.2},
                          {"update_min_a", kPi / 6.0},
                          {"resample_interval", 2},
                          {"selective_resampling", false},
                          {"min_effective_share", 0.0},
                          {"laser_sigma_sparse", 0.0},
                          {"recovery_margin", 1.0},
                          {"recovery_reference", std::string("mean")},
                          {"max_particles", 5000}};
  std::vector<FilterDescription> filters;
  filters.push_back(particleFilter(
      "mcl", "Monte Carlo localization with a fixed number of particles.", Size::kFixed,
      Elsewhere::kNowhere, {{"max_particles", 2000}}, source({{"max_particles", 5000}})));
  filters.push_back(particleFilter("kld", "MCL with as many particles as KLD-sampling asks for.",
                                   Size::kKld, Elsewhere::kNowhere, {}, source(kld_source)));
  filters.push_back(particleFilter("amcl",
                                   "KLD-sampling that looks elsewhere when likelihoods fall "
                                   "(augmented MCL).",
                                   Size::kKld, Elsewhere::kAugmented, {}, amcl_stock));
  return filters;
}

}  // namespace adaptive_localization
