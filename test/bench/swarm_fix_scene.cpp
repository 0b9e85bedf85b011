// SPDX-License-Identifier: BSD-3-Clause
#include "bench/swarm_fix_scene.hpp"

#include "adaptive_localization/filters/builtins.hpp"
#include "ser/place_sampler.hpp"
#include "sim/rasterize.hpp"
#include "sim/world.hpp"

namespace adaptive_localization {
namespace {

constexpr int kBeams = 11;
constexpr double kMaxRange = 10.0;  // m
constexpr double kRadius = 0.2;     // m, of the robot

}  // namespace

SwarmFixScene::SwarmFixScene(const std::string& world_file, double resolution, double noise)
    : world_file_(world_file),
      noise_(noise),
      world_(makeWorld(loadFloorPlan(world_file), false)),
      free_space_(world_, kRadius),
      map_(std::make_shared<const OccupancyGrid>(rasterize(loadFloorPlan(world_file), resolution))),
      distance_field_(std::make_shared<const DistanceField>(*map_)) {
  EnergyGridOptions options;
  options.energy_max_range = kMaxRange;
  options.energy_grid_max_memory = 2000.0;
  places_ = std::make_shared<Places>(map_, distance_field_, options, GlobalSearchOptions{});
  Rng rng(1);
  const auto grid = places_->energyGrid(observe(place(rng), rng).scan);
  rows_ = std::make_shared<const RangeRows>(grid->sharedRanges());
  MatchOptions matching;
  matching.line_map = world_file;
  SurfaceMaps surfaces(map_, distance_field_->quality());
  matcher_ = std::make_unique<const ScanMatcher>(makeScanMatcher(matching, surfaces));
}

Pose2 SwarmFixScene::place(Rng& rng) const {
  const Eigen::Vector2d at = free_space_.sample(rng);
  return {at.x(), at.y(), rng.uniform(-kPi, kPi)};
}

Observations SwarmFixScene::observe(const Pose2& T_map_base, Rng& rng) const {
  LaserScan message;
  message.angle_min = -kPi / 2;
  message.angle_increment = kPi / 180;
  message.range_max = kMaxRange;
  for (int i = 0; i <= 180; ++i) {
    const double theta = T_map_base.theta + message.angle_min + i * message.angle_increment;
    const double range = world_->range({T_map_base.x, T_map_base.y, theta}, 2.0 * kMaxRange);
    message.ranges.push_back(static_cast<float>(range + rng.normal(0.0, noise_)));
  }
  Observations observations;
  observations.scan = toScan(message, LaserMount{}, ScanOptions{});
  return observations;
}

Eigen::ArrayXXd SwarmFixScene::spread(const std::string& where, int count,
                                      const Observations& observations, Rng& rng) const {
  std::unique_ptr<PoseSampler> sampler;
  if (where == "places") {
    sampler = std::make_unique<PlaceSampler>(PlaceSamplerOptions{}, places_, map_);
  } else if (where == "ser") {
    sampler = std::make_unique<SerSampler>(places_, map_);
  } else if (where == "free") {
    sampler = std::make_unique<FreeSpaceSampler>(map_);
  } else {
    throw std::invalid_argument("start: got '" + where + "', expected free, ser or places");
  }
  sampler->condition(observations);
  Eigen::ArrayXXd positions(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Pose2 pose = sampler->draw(rng);
    positions.row(i) << pose.x, pose.y, pose.theta;
  }
  return positions;
}

TableObjective SwarmFixScene::objective(const Scan& scan) const {
  RangeObjectiveOptions options;
  options.swarm_beams = kBeams;
  options.swarm_error = "relative";
  return TableObjective(options, scan, rows_);
}

Pose2 SwarmFixScene::matched(const Pose2& guess, const Scan& scan) const {
  const Match match = matcher_->match(guess, scan);
  return match.isGood() ? match.T_map_base : guess;
}

SearchSpace SwarmFixScene::space(bool is_torus) const {
  SearchSpace space;
  const Lattice& lattice = map_->lattice();
  const Pose2& origin = lattice.origin();
  space.low = Eigen::Array3d(origin.x, origin.y, -kPi);
  space.high = Eigen::Array3d(origin.x + lattice.width() * lattice.resolution(),
                              origin.y + lattice.height() * lattice.resolution(), kPi);
  space.is_torus = is_torus;
  space.has_heading = true;
  return space;
}

FilterContext SwarmFixScene::contextFor(const std::string& filter, int particles,
                                        std::uint64_t seed, const Parameters& options) const {
  FilterContext context{builtins(), {map_, distance_field_, places_}, {}, seed};
  const std::size_t slash = filter.find('/');
  const std::string preset = slash == std::string::npos ? "recommended" : filter.substr(slash + 1);
  const FilterDescription& core = builtins().filters.find(filter.substr(0, slash));
  for (const auto& [key, value] : core.preset(preset)) {
    context.parameters.set(key, value);
  }
  context.parameters.set("line_map", OptionValue(world_file_));
  context.parameters.set("swarm_size", OptionValue(particles));
  context.parameters.set("max_particles", OptionValue(particles));
  context.parameters.set("min_particles", OptionValue(std::min(particles, 100)));
  Parameters all = options;
  all.fill(context.parameters);
  context.parameters = std::move(all);
  return context;
}

}  // namespace adaptive_localization
