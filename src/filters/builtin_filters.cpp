// SPDX-License-Identifier: BSD-3-Clause
#include "builtin_filters.hpp"

#include <stdexcept>

#include "adaptive_localization/observation/composed_model.hpp"
#include "elsewhere.hpp"
#include "grid_filters.hpp"
#include "kalman_filters.hpp"
#include "map/segment_index.hpp"
#include "match/line_map.hpp"
#include "particle/kidnap_test.hpp"
#include "particle_filter.hpp"
#include "presets.hpp"
#include "shared_parts.hpp"
#include "swarm_filter.hpp"
#include "swarm_presets.hpp"
#include "update_price.hpp"

namespace adaptive_localization {
namespace {

enum class Size { kFixed, kKld };
enum class Looks { kNowhere, kAugmented, kKidnapTest };  // when particles are drawn elsewhere

std::unique_ptr<Filter> makeParticleFilter(Size size, Looks looks, const FilterContext& context) {
  const Parameters& given = context.parameters;
  const auto& observations = context.models.observations;
  checkPriceOfUpdate(given, observations.find(given.read<ObservationChoice>().laser_model_type));
  ParticleFilterParts parts;
  parts.motion = makeMotionModel(context.models.motions, given);
  const Ground& ground = context.ground;
  auto senses = makeSenses(context.models.senses, given, ground.map, ground.field);
  senses->add(makeObservationModel(observations, given, ground.map, ground.field));
  parts.observation = std::move(senses);
  parts.resampling = makeResampling(context.models.resamplings, given);
  const auto sizes = given.read<SampleSizeOptions>();
  parts.size = size == Size::kKld ? kldSampleSize(sizes) : fixedSampleSize(sizes);
  if (looks == Looks::kNowhere) {
    parts.exploration = noExploration();
    parts.elsewhere = std::make_unique<FreeSpaceSampler>(context.ground.map);
  } else {
    const auto places = placesFor(context.ground, given);
    parts.elsewhere = makeSampler(given, context.ground.map, places);
    parts.exploration =
        looks == Looks::kKidnapTest
            ? kidnapTest(given.read<KidnapOptions>(), context.ground.map, context.ground.field)
            : augmentedExploration(given.read<ExplorationOptions>());
  }
  return std::make_unique<ParticleFilter>(given.read<ParticleFilterOptions>(), std::move(parts),
                                          context.seed);
}

std::vector<OptionDescription> optionsOf(Looks looks) {
  std::vector<OptionDescription> all;
  const auto append = [&all](const std::vector<OptionDescription>& rows) {
    all.insert(all.end(), rows.begin(), rows.end());
  };
  append(describe(MotionChoice{}));
  append(describe(ObservationChoice{}));
  append(describe(SampleSizeOptions{}));
  append(describe(ResamplingChoice{}));
  append(describe(ParticleFilterOptions{}));
  if (looks == Looks::kNowhere) return all;
  append(looks == Looks::kKidnapTest ? describe(KidnapOptions{}) : describe(ExplorationOptions{}));
  append(describe(ElsewhereOptions{}));
  append(describe(PlaceSamplerOptions{}));
  return all;
}

FilterDescription particleFilter(const std::string& name, const std::string& sentence, Size size,
                                 Looks looks, Preset recommended, Preset seed) {
  const auto make = [size, looks](const FilterContext& context) {
    return makeParticleFilter(size, looks, context);
  };
  return {name, sentence, make, optionsOf(looks), std::move(recommended), std::move(seed)};
}

enum class Rule { kParticleSwarm, kBats, kLeaders };

std::unique_ptr<SwarmMove> makeSwarmMove(Rule rule, const Parameters& given) {
  if (rule == Rule::kParticleSwarm) return std::make_unique<ParticleSwarmMove>();
  if (rule == Rule::kBats) return std::make_unique<BatMove>(given.read<BatOptions>());
  return std::make_unique<BatMove>(given.read<BatOptions>(), given.read<LeaderOptions>());
}

/// Over the walls of a plan where swarm_ranges says so, else over the map's cells.
RayCast rayCastFor(const SwarmFixOptions& fixing, const MatchOptions& matching,
                   const Ground& ground) {
  if (fixing.swarm_ranges != "lines") return castOverCells(ground.map, ground.field);
  if (matching.line_map.empty()) {
    throw std::invalid_argument(
        "option 'line_map': got '', expected a floor plan, as swarm_ranges is 'lines'");
  }
  const auto walls =
      std::make_shared<const SegmentIndex>(loadLineMap(matching.line_map, ground.map->lattice()));
  return [walls](const Pose2& ray, double max_range) { return walls->range(ray, max_range); };
}

std::unique_ptr<Filter> makeSwarmFilter(Rule rule, const FilterContext& context) {
  const Parameters& given = context.parameters;
  const auto places = placesFor(context.ground, given);
  SwarmFilterParts parts;
  parts.motion = makeMotionModel(context.models.motions, given);
  parts.move = makeSwarmMove(rule, given);
  std::optional<LeaderOptions> leaders;
  if (rule == Rule::kLeaders) leaders = given.read<LeaderOptions>();
  const auto fixing = given.read<SwarmFixOptions>();
  const auto matching = given.read<MatchOptions>();
  parts.fixer = std::make_unique<SwarmFixer>(fixing, given.read<RangeObjectiveOptions>(), leaders,
                                             given.read<EnergyGridOptions>().energy_max_range,
                                             context.ground.map, context.ground.field, places,
                                             rayCastFor(fixing, matching, context.ground));
  if (fixing.swarm_match) {
    parts.match = matchBy(scanMatcherFor(context.ground, matching));
  }
  parts.elsewhere = makeSampler(given, context.ground.map, places);
  parts.senses = makeSenses(context.models.senses, given, context.ground.map, context.ground.field);
  return std::make_unique<SwarmFilter>(given.read<SwarmFilterOptions>(), std::move(parts),
                                       context.seed);
}

FilterDescription swarmFilter(const std::string& name, const std::string& sentence, Rule rule,
                              Preset recommended, Preset seed) {
  std::vector<OptionDescription> all;
  const auto append = [&all](const std::vector<OptionDescription>& rows) {
    all.insert(all.end(), rows.begin(), rows.end());
  };
  append(describe(MotionChoice{}));
  append(describe(SwarmFilterOptions{}));
  append(describe(SwarmFixOptions{}));
  append(describe(RangeObjectiveOptions{}));
  if (rule != Rule::kParticleSwarm) append(describe(BatOptions{}));
  if (rule == Rule::kLeaders) append(describe(LeaderOptions{}));
  append(describe(ElsewhereOptions{}));
  append(describe(PlaceSamplerOptions{}));
  const auto make = [rule](const FilterContext& context) { return makeSwarmFilter(rule, context); };
  return {name, sentence, make, std::move(all), std::move(recommended), std::move(seed)};
}

}  // namespace

std::vector<FilterDescription> builtinFilters() {
  std::vector<FilterDescription> filters;
  filters.push_back(
      particleFilter("mcl", "Monte Carlo localization with a fixed number of particles.",
                     Size::kFixed, Looks::kNowhere, {{"max_particles", 2000}, {"refine", true}},
                     Preset{{"max_particles", 5000}} + sourceOfAll()));
  filters.back().more_presets["fp"] = sourceOfComparedParticles();
  filters.push_back(particleFilter("kld", "MCL with as many particles as KLD-sampling asks for.",
                                   Size::kKld, Looks::kNowhere, {{"refine", true}},
                                   sourceOfKld() + sourceOfAll()));
  filters.push_back(particleFilter(
      "amcl",
      "KLD-sampling that looks elsewhere when likelihoods fall "
      "(augmented MCL).",
      Size::kKld, Looks::kAugmented,
      {{"recovery", true}, {"recovery_alpha_slow", 0.0}, {"refine", true}}, stockAmcl()));
  filters.push_back(particleFilter(
      "samcl",
      "Fixed number of particles; where none explains the scans, looks in the Similar Energy "
      "Region (self-adaptive MCL).",
      Size::kFixed, Looks::kKidnapTest,
      {{"max_particles", 5000},
       {"elsewhere", std::string("ser")},
       {"recovery", true},
       {"refine", true}},
      Preset{{"max_particles", 5000}} + sourceOfSamcl() + sourceOfAll()));
  filters.push_back(particleFilter(
      "sa_kld",
      "SAMCL with as many particles as KLD-sampling asks for, from the first scan on (SA-KLD).",
      Size::kKld, Looks::kKidnapTest, {{"recovery", true}, {"refine", true}},
      Preset{{"kidnap_arm_particles", 1000}} + sourceOfSamcl() + sourceOfKld() + sourceOfAll()));
  const Preset recovery{{"recovery", true}};
  filters.push_back(swarmFilter("pso", "Particle swarm: looks for the pose that explains the scan.",
                                Rule::kParticleSwarm, recovery, sourceOfSwarms()));
  filters.push_back(swarmFilter("ba", "Bat algorithm: the same with bats.", Rule::kBats, recovery,
                                sourceOfBats() + sourceOfSwarms()));
  filters.push_back(swarmFilter("lbba", "Leader-based bat algorithm: bats that follow leaders.",
                                Rule::kLeaders, recovery,
                                sourceOfLeaders() + sourceOfBats() + sourceOfSwarms()));
  filters.push_back(ekfIcp());
  filters.push_back(markov());
  return filters;
}

}  // namespace adaptive_localization
