// SPDX-License-Identifier: BSD-3-Clause
#include "swarm_bats.hpp"

#include <algorithm>

#include "adaptive_localization/particle/summary.hpp"
#include "swarm/leaders.hpp"

namespace adaptive_localization {
namespace {

constexpr double kTemperature = 0.004;  // m, 1: a place so much worse is e times less likely
constexpr double kFloorXy = 0.04;       // m: what a swarm is off by at the least
constexpr double kFloorTheta = 0.02;    // rad

Eigen::ArrayXd weightsOf(const Particles& bats) {
  const Eigen::ArrayXd weights = (bats.log_weight - bats.log_weight.maxCoeff()).exp();
  return weights / weights.sum();
}

Eigen::Matrix3d floorCovariance() {
  return Eigen::Vector3d(kFloorXy * kFloorXy, kFloorXy * kFloorXy, kFloorTheta * kFloorTheta)
      .asDiagonal();
}

}  // namespace

Eigen::ArrayXXd columnsOf(const Particles& particles) {
  Eigen::ArrayXXd columns(particles.size(), 3);
  columns << particles.x, particles.y, particles.theta;
  return columns;
}

Eigen::ArrayXXd columnsAround(double heading, const Particles& particles) {
  Eigen::ArrayXXd columns = columnsOf(particles);
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    columns(i, 2) = heading + wrapAngle(columns(i, 2) - heading);
  }
  return columns;
}

SearchSpace spaceAround(const Eigen::ArrayXXd& positions) {
  constexpr double kLeast = 0.02;  // m, rad
  SearchSpace space;
  const Eigen::ArrayXd low = positions.colwise().minCoeff();
  const Eigen::ArrayXd high = positions.colwise().maxCoeff();
  const Eigen::ArrayXd middle = 0.5 * (low + high);
  Eigen::ArrayXd reach = high - low + kLeast;
  reach[2] = std::min(reach[2], kPi);
  space.low = middle - reach;
  space.high = middle + reach;
  space.has_heading = true;
  return space;
}

Eigen::ArrayXXd thinned(const Eigen::ArrayXXd& rows, Eigen::Index count) {
  if (count >= rows.rows()) return rows;
  Eigen::ArrayXXd some(count, rows.cols());
  for (Eigen::Index i = 0; i < count; ++i) some.row(i) = rows.row(i * rows.rows() / count);
  return some;
}

Particles particlesOf(const Swarm& swarm) {
  Particles bats(swarm.size());
  for (Eigen::Index i = 0; i < swarm.size(); ++i) {
    bats.setPose(i, {swarm.position(i, 0), swarm.position(i, 1), wrapAngle(swarm.position(i, 2))});
  }
  bats.log_weight = -(swarm.cost - swarm.cost.minCoeff()) / kTemperature;
  return bats;
}

Estimate estimateOf(const Particles& bats) {
  Estimate estimate = summarize(bats, weightsOf(bats));
  for (Mode& mode : estimate.modes) mode.covariance += floorCovariance();
  estimate.covariance += floorCovariance();
  return estimate;
}

Particles leadersOf(const Swarm& swarm, const Particles& bats, const LeaderOptions& options) {
  const auto leading =
      bestBats(swarm, numberOfLeaders(swarm.size(), options.leaders_per_bats, options.min_leaders));
  Particles leaders(static_cast<Eigen::Index>(leading.size()));
  for (std::size_t j = 0; j < leading.size(); ++j) {
    leaders.setPose(static_cast<Eigen::Index>(j), bats.pose(leading[j]));
  }
  return leaders;
}

void stepBackToBest(Swarm& swarm) {
  for (Eigen::Index i = 0; i < swarm.size(); ++i) {
    if (!(swarm.own_best_cost[i] < swarm.cost[i])) continue;
    swarm.position.row(i) = swarm.own_best.row(i);
    swarm.cost[i] = swarm.own_best_cost[i];
  }
}

}  // namespace adaptive_localization
