// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/swarm_fixes.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>

#include "adaptive_localization/eval/metrics.hpp"
#include "adaptive_localization/sim/free_space.hpp"
#include "adaptive_localization/sim/rasterize.hpp"
#include "adaptive_localization/sim/world.hpp"
#include "adaptive_localization/swarm/range_objective.hpp"

namespace adaptive_localization {
namespace {

constexpr int kBeams = 11;
constexpr double kMaxRange = 10.0, kNoise = 0.031;               // m
constexpr double kRight = 0.15, kRightTurn = 5.0 * kPi / 180.0;  // m, rad

Scan scanAt(const World& world, const Pose2& pose, Rng& rng) {
  LaserScan message;
  message.angle_min = -kPi / 2;
  message.angle_increment = kPi / 180;
  message.range_max = kMaxRange;
  for (int i = 0; i <= 180; ++i) {
    const double theta = pose.theta + message.angle_min + i * message.angle_increment;
    const double range = world.range({pose.x, pose.y, theta}, 2.0 * kMaxRange);
    message.ranges.push_back(static_cast<float>(range + rng.normal(0.0, kNoise)));
  }
  return toScan(message, LaserMount{}, ScanOptions{});
}

/// The map's ends, and all headings.
SearchSpace spaceOf(const Lattice& lattice, bool is_torus) {
  SearchSpace space;
  const Pose2& origin = lattice.origin();
  const double resolution = lattice.resolution();
  space.low = Eigen::Array3d(origin.x, origin.y, -kPi);
  space.high = Eigen::Array3d(origin.x + lattice.width() * resolution,
                              origin.y + lattice.height() * resolution, kPi);
  space.is_torus = is_torus;
  space.has_heading = true;
  return space;
}

/// One scan after another, and the swarm that looks for where it was taken.
class Fixes {
 public:
  explicit Fixes(const SwarmFixPlan& plan)
      : plan_(plan),
        floor_(loadFloorPlan(plan.world)),
        world_(makeWorld(floor_, false)),
        free_space_(world_, 0.2),
        map_(rasterize(floor_, plan.resolution)),
        rows_(std::make_shared<const RangeRows>(
            std::make_shared<const RangeTable>(map_, kMaxRange))) {}

  SwarmFixCell race(const SwarmRacer& racer, int searchers) const {
    SwarmFixCell cell{racer.name, searchers, plan_.runs};
    std::vector<double> times;
    for (int seed = 1; seed <= plan_.runs; ++seed) {
      Rng rng(static_cast<std::uint64_t>(seed));
      times.push_back(fix(*racer.move, rng, cell));
    }
    cell.iterations /= plan_.runs;
    cell.error_mm /= std::max(1, cell.found);
    cell.ms_median = quantile(times, 0.5);
    return cell;
  }

 private:
  double fix(const SwarmMove& move, Rng& rng, SwarmFixCell& cell) const {
    const Eigen::Vector2d place = free_space_.sample(rng);
    const Pose2 truth{place.x(), place.y(), rng.uniform(-kPi, kPi)};
    const Scan scan = scanAt(*world_, truth, rng);
    const Eigen::ArrayXXd start = spread(cell.searchers, rng);
    RangeObjectiveOptions options;
    options.swarm_beams = kBeams;
    options.swarm_error = "relative";
    StopRule rule;
    rule.tolerance = 0.03;

    const auto begin = std::chrono::steady_clock::now();
    const TableObjective objective(options, scan, rows_);
    Swarm swarm(spaceOf(map_.lattice(), plan_.is_torus), start, objective);
    const SearchResult result = search(swarm, move, objective, rule, rng);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - begin;

    const Pose2 found{swarm.best[0], swarm.best[1], swarm.best[2]};
    const double error = distance(found, truth);
    cell.iterations += result.iterations;
    cell.reached += result.is_reached ? 1 : 0;
    if (error < kRight && std::abs(wrapAngle(found.theta - truth.theta)) < kRightTurn) {
      ++cell.found;
      cell.error_mm += 1000.0 * error;
    }
    return taken.count();
  }

  Eigen::ArrayXXd spread(int count, Rng& rng) const {
    Eigen::ArrayXXd positions(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Vector2d place = free_space_.sample(rng);
      positions.row(i) << place.x(), place.y(), rng.uniform(-kPi, kPi);
    }
    return positions;
  }

  SwarmFixPlan plan_;
  FloorPlan floor_;
  std::shared_ptr<const World> world_;
  FreeSpace free_space_;
  OccupancyGrid map_;
  std::shared_ptr<const RangeRows> rows_;
};

}  // namespace

std::vector<SwarmFixCell> raceFixes(const SwarmFixPlan& plan) {
  const Fixes fixes(plan);
  std::vector<SwarmFixCell> cells;
  for (const SwarmRacer& racer : swarmRacers()) {
    for (const int count : plan.searchers) cells.push_back(fixes.race(racer, count));
  }
  return cells;
}

std::string toTable(const std::vector<SwarmFixCell>& cells) {
  std::string table =
      "| move | searchers | found, % | reached 3 %, % | iterations | error, mm | ms per fix |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const SwarmFixCell& cell : cells) {
    char row[200];
    std::snprintf(row, sizeof row, "| %s | %d | %.0f | %.0f | %.0f | %.1f | %.2f |\n",
                  cell.move.c_str(), cell.searchers, 100.0 * cell.found / cell.runs,
                  100.0 * cell.reached / cell.runs, cell.iterations, cell.error_mm, cell.ms_median);
    table += row;
  }
  return table;
}

}  // namespace adaptive_localization
