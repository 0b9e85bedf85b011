// SPDX-License-Identifier: BSD-3-Clause
// What scoring, resampling, updating, building fields and energy grids, searching and matching
// cost, on one thread. An item is a particle and beam where beams count, else a particle, a cell, a
// ray, a pose or, of a match, a beam.
#include <string>
#include <utility>

#include "adaptive_localization/filters/builtins.hpp"
#include "adaptive_localization/observation/observation_model.hpp"
#include "adaptive_localization/particle/resampling.hpp"
#include "core/parallel.hpp"
#include "map/ray_caster.hpp"
#include "measure.hpp"
#include "observation/missed_walls.hpp"
#include "plain_field.hpp"
#include "support/resident_memory.hpp"
#include "toy_building.hpp"

namespace adaptive_localization {
namespace {

constexpr int kSide = 400;  // cells

const std::shared_ptr<const OccupancyGrid>& building() {
  static const auto map = toyBuilding(kSide);
  return map;
}

FilterContext contextFor(const std::shared_ptr<const OccupancyGrid>& map) {
  return {builtins(), map};
}

void scorePlain(benchmark::State& state, int particles, int beams, Spread kind) {
  const PlainField field(*contextFor(building()).ground.field);
  const Observations observations = observe(building(), kTruth, beams);
  auto samples = PlainField::samplesOf(spread(kind, particles, building()));
  for (auto _ : state) {
    for (auto& sample : samples) sample.weight = 1.0;
    field.score(observations.scan, samples);
    benchmark::DoNotOptimize(samples.data());
  }
  countItems(state, static_cast<std::int64_t>(particles) * beams);
}

void score(benchmark::State& state, const std::string& name, int particles, int beams,
           Spread kind) {
  const auto model = builtins().observations.make(name, Parameters{}, building(),
                                                  contextFor(building()).ground.field);
  const Observations observations = observe(building(), kTruth, beams);
  const Particles cloud = spread(kind, particles, building());
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(particles);
  for (auto _ : state) {
    model->score(observations, cloud, log_likelihood);
    benchmark::DoNotOptimize(log_likelihood.data());
  }
  countItems(state, static_cast<std::int64_t>(particles) * beams);
}

/// What is added where most beams see nothing: no-returns are followed to where walls are.
void missWalls(benchmark::State& state, int particles) {
  const auto field = contextFor(building()).ground.field;
  Scan scan;
  scan.max_range = 8.0;
  scan.no_return_bearing = Eigen::ArrayXf::LinSpaced(180, -1.57F, 1.57F);
  const Particles cloud = spread(Spread::kTracking, particles, building());
  for (auto _ : state) benchmark::DoNotOptimize(missedWalls(scan, cloud, *field));
  countItems(state, particles);
}

void resample(benchmark::State& state, int count) {
  const Particles cloud = spread(Spread::kTracking, count, building());
  Rng rng(4);
  Eigen::ArrayXd log_weight(count);
  for (Eigen::Index i = 0; i < count; ++i) log_weight[i] = 2.0 * rng.normal();
  for (auto _ : state) {
    const Eigen::ArrayXd weights = normalisedWeights(log_weight);
    benchmark::DoNotOptimize(select(cloud, systematicIndices(weights, count, rng)));
  }
  countItems(state, count);
}

/// A robot that goes to and fro by 10 cm; every update moves, scores, resamples and summarizes.
void update(benchmark::State& state, const std::string& core, int particles, int beams) {
  FilterContext context = contextFor(building());
  context.parameters.set("min_particles", OptionValue{particles});
  context.parameters.set("max_particles", OptionValue{particles});
  context.parameters.set("swarm_size", OptionValue{particles});
  context.parameters.set("selective_resampling", OptionValue{false});
  const auto filter = builtins().filters.make(core, context);
  const Pose2 motion{0.1, 0.0, 0.02};
  const Observations there = observe(building(), kTruth * motion, beams);
  const Observations here = observe(building(), kTruth, beams);
  Gaussian2 prior{kTruth, Eigen::Matrix3d::Zero()};
  prior.covariance.diagonal() << 0.04, 0.04, 0.01;
  filter->reset(prior);
  bool is_here = true;
  for (auto _ : state) {
    benchmark::DoNotOptimize(is_here ? filter->update(motion, there)
                                     : filter->update(inverse(motion), here));
    is_here = !is_here;
  }
  countItems(state, static_cast<std::int64_t>(particles) * beams);
}

void makeDistanceField(benchmark::State& state, const OccupancyGrid& map) {
  for (auto _ : state) benchmark::DoNotOptimize(DistanceField(map));
  countItems(state, static_cast<std::int64_t>(map.lattice().size()));
}

void distanceField(benchmark::State& state, int side) {
  const auto map = toyBuilding(side);
  makeDistanceField(state, *map);

  const double before = residentMegabytes();  // what a running filter holds for each cell
  const FilterContext context = contextFor(toyBuilding(side));
  const auto model =
      makeObservationModel(builtins().observations, {}, context.ground.map, context.ground.field);
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(1);
  model->score(observe(map, kTruth, 60), Particles(1), log_likelihood);
  state.counters["bytes_per_cell"] =
      1e6 * (residentMegabytes() - before) / static_cast<double>(map->lattice().size());
}

void rayCast(benchmark::State& state) {
  const RayCaster caster(building());
  const Particles starts = spread(Spread::kGlobal, 1000, building());
  for (auto _ : state) {
    for (Eigen::Index i = 0; i < starts.size(); ++i) {
      benchmark::DoNotOptimize(caster.range(starts.pose(i), 100.0));
    }
  }
  countItems(state, starts.size());
}

void registerScores() {
  const std::pair<int, int> sizes[] = {{2000, 60}, {10000, 60}};
  const std::pair<const char*, Spread> spreads[] = {{"tracking", Spread::kTracking},
                                                    {"global", Spread::kGlobal}};
  for (const auto& [particles, beams] : sizes) {
    for (const auto& [how, kind] : spreads) {
      const std::string suffix =
          "/" + std::to_string(particles) + "/" + std::to_string(beams) + "/" + how;
      benchmark::RegisterBenchmark(("score/plain" + suffix).c_str(), scorePlain, particles, beams,
                                   kind);
      for (const std::string model :
           {"likelihood_field", "likelihood_field_prob", "likelihood_field_cubed", "beam"}) {
        benchmark::RegisterBenchmark(("score/" + model + suffix).c_str(), score, model, particles,
                                     beams, kind);
      }
    }
  }
}

/// What scripts/plot_costs draws: one thing grows at a time.
void registerCosts() {
  const auto add = [](const std::string& what, int size, auto&& run) {
    const std::string name = "cost/" + what + "/" + std::to_string(size);
    return benchmark::RegisterBenchmark(name.c_str(), run);
  };
  for (const int particles : {100, 1000, 10000, 100000, 1000000}) {
    add("particles", particles, [=](auto& state) { update(state, "kld", particles, 60); });
  }
  for (const int beams : {10, 30, 60, 180, 360, 720}) {
    add("beams", beams, [=](auto& state) { update(state, "kld", 2000, beams); });
  }
  for (const int side : {100, 300, 1000, 3000, 10000, 20000}) {
    auto* fields = add("cells", side * side,
                       [=](auto& state) { makeDistanceField(state, *toyBuilding(side)); });
    if (side > 3000) fields->Iterations(1)->Repetitions(1);
  }
}

void registerOthers() {
  for (const int particles : {500, 4000, 20000}) {
    benchmark::RegisterBenchmark(("missed_walls/" + std::to_string(particles)).c_str(), missWalls,
                                 particles);
  }
  for (const int count : {1000, 10000, 50000, 100000, 1000000}) {
    benchmark::RegisterBenchmark(("resample/" + std::to_string(count)).c_str(), resample, count);
  }
  for (const auto& core : builtins().filters.names()) {
    for (const auto& [particles, beams] : {std::pair{2000, 60}, {7500, 30}, {10000, 60}}) {
      const std::string name =
          "update/" + core + "/" + std::to_string(particles) + "/" + std::to_string(beams);
      benchmark::RegisterBenchmark(name.c_str(), update, core, particles, beams);
    }
  }
  for (const int threads : {1, 2}) {
    const std::string name = "update/mcl/100000/60/threads/" + std::to_string(threads);
    const auto run = [threads](benchmark::State& state) {
      setThreads(threads);
      update(state, "mcl", 100000, 60);
      setThreads(1);
    };
    benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime();
  }
  for (const int side : {400, 4000}) {
    benchmark::RegisterBenchmark(("distance_field/" + std::to_string(side)).c_str(), distanceField,
                                 side);
  }
  benchmark::RegisterBenchmark("ray_cast", rayCast);
}

}  // namespace
}  // namespace adaptive_localization

int main(int argc, char** argv) {
  adaptive_localization::setThreads(1);
  adaptive_localization::registerScores();
  adaptive_localization::registerOthers();
  adaptive_localization::registerCosts();
  adaptive_localization::registerPlaces();
  adaptive_localization::registerMatches();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
