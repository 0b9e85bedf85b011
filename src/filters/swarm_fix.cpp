// SPDX-License-Identifier: BSD-3-Clause
#include "swarm_fix.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "near_objective.hpp"
#include "swarm_bats.hpp"

namespace adaptive_localization {
namespace {

constexpr double kHitTruncation = 0.3;  // m
constexpr int kNearIterations = 12;     // a narrow cloud needs no more
constexpr int kNearPatience = 2;

}  // namespace

SwarmFixer::SwarmFixer(const SwarmFixOptions& options, const RangeObjectiveOptions& objective,
                       const std::optional<LeaderOptions>& leaders, double max_range,
                       std::shared_ptr<const OccupancyGrid> map,
                       std::shared_ptr<const DistanceField> distance_field,
                       std::shared_ptr<Places> places, RayCast cast)
    : options_(options),
      objective_(objective),
      leaders_(leaders),
      max_range_(options.swarm_ranges == "table" ? max_range
                                                 : std::numeric_limits<double>::infinity()),
      map_(std::move(map)),
      distance_field_(std::move(distance_field)),
      places_(std::move(places)),
      cast_(std::move(cast)) {
  const Lattice& lattice = map_->lattice();
  const double width = lattice.width() * lattice.resolution();
  const double height = lattice.height() * lattice.resolution();
  whole_.low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  whole_.high = -whole_.low;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(width, 0), Eigen::Vector2d(0, height),
        Eigen::Vector2d(width, height)}) {
    const Eigen::Vector2d at = lattice.origin() * corner;
    whole_.low.head(2) = whole_.low.head(2).min(at.array());
    whole_.high.head(2) = whole_.high.head(2).max(at.array());
  }
  whole_.low[2] = -kPi;
  whole_.high[2] = kPi;
  whole_.has_heading = true;
  whole_.is_torus = options_.wrap_map;
}

SwarmPrice SwarmFixer::priceOf(bool is_cast) const {
  return {objective_.swarm_beams, is_cast, leaders_};
}

int SwarmFixer::affordable(int searchers) const {
  return static_cast<int>(
      priceOf(options_.swarm_ranges != "table").affordable(searchers, 1e6 * options_.swarm_budget));
}

double SwarmFixer::costOf(const Pose2& T_map_base, const Observations& observations) const {
  Eigen::ArrayXXd position(1, 3);
  position << T_map_base.x, T_map_base.y, T_map_base.theta;
  Eigen::ArrayXd cost(1);
  CastObjective(objective_, observations.scan, max_range_, map_, cast_).evaluate(position, cost);
  return cost[0];
}

double SwarmFixer::worst() const {
  return worstOf(objective_);
}

/// The table is there once somebody needs it and, where it is made in the background, it is done.
std::unique_ptr<RangeObjective> SwarmFixer::rangesOf(const Observations& observations) {
  const Scan& scan = observations.scan;
  if (options_.swarm_ranges == "table" && scan.hits() > 0) {
    const auto grid = places_->energyGrid(scan);
    if (grid && grid != grid_) {
      if (!grid_ || grid->sharedRanges() != grid_->sharedRanges()) {
        rows_ = std::make_shared<const RangeRows>(grid->sharedRanges());
      }
      grid_ = grid;
    }
    if (grid) return std::make_unique<TableObjective>(objective_, scan, rows_);
  }
  return std::make_unique<CastObjective>(objective_, scan, max_range_, map_, cast_);
}

StopRule SwarmFixer::stopRule() const {
  StopRule rule;
  rule.tolerance = options_.swarm_tolerance;
  rule.max_iterations = options_.swarm_max_iterations;
  rule.patience = options_.swarm_patience;
  return rule;
}

SwarmFix SwarmFixer::fix(const Particles& start, const SwarmMove& move,
                         const Observations& observations, Rng& rng) {
  const auto objective = rangesOf(observations);
  SwarmFix fix = searchIn(whole_, columnsOf(start), move, *objective, stopRule(), rng);
  fix.cost = costOf(fix.estimate.T_map_base, observations);
  return fix;
}

SwarmFix SwarmFixer::fixNear(const Gaussian2& odometry, const Particles& start,
                             const SwarmMove& move, const Observations& observations, Rng& rng) {
  const bool has_odometry = options_.swarm_near == "hits";
  std::unique_ptr<Objective> objective;
  if (has_odometry) {
    FieldObjective field(observations.scan, objective_.swarm_beams, kHitTruncation,
                         distance_field_);
    objective = std::make_unique<NearObjective>(std::move(field), odometry);
  } else {
    objective = rangesOf(observations);
  }
  StopRule rule = stopRule();
  if (options_.swarm_match) {  // does the rest
    rule.max_iterations = std::min(rule.max_iterations, kNearIterations);
    rule.patience = kNearPatience;
  }
  const Eigen::ArrayXXd positions = columnsAround(odometry.mean.theta, start);
  SwarmFix fix = searchIn(spaceAround(positions), positions, move, *objective, rule, rng);
  fix.has_odometry = has_odometry;
  fix.cost = costOf(fix.estimate.T_map_base, observations);
  return fix;
}

Estimate SwarmFixer::answerOf(const Swarm& swarm, const Particles& bats) const {
  Estimate answer = estimateOf(bats);
  if (options_.swarm_answer == "place") return answer;
  answer.T_map_base = {swarm.best[0], swarm.best[1], wrapAngle(swarm.best[2])};
  answer.modes.front().T_map_base = answer.T_map_base;
  return answer;
}

SwarmFix SwarmFixer::searchIn(const SearchSpace& space, const Eigen::ArrayXXd& start,
                              const SwarmMove& move, const Objective& objective, StopRule rule,
                              Rng& rng) const {
  const SwarmPrice price = priceOf(dynamic_cast<const CastObjective*>(&objective) != nullptr);
  const double budget = 1e6 * options_.swarm_budget;
  Swarm swarm(space, thinned(start, price.affordable(start.rows(), budget)), objective);
  rule.max_evaluations = budget / price.ofOne(swarm.size());
  SwarmFix fix;
  fix.iterations = search(swarm, move, objective, rule, rng).iterations;
  stepBackToBest(swarm);
  fix.bats = particlesOf(swarm);
  fix.estimate = answerOf(swarm, fix.bats);
  if (leaders_) fix.leaders = leadersOf(swarm, fix.bats, *leaders_);
  return fix;
}

}  // namespace adaptive_localization
