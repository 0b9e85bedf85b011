// SPDX-License-Identifier: BSD-3-Clause
#include "markov_filter.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>
#include <stdexcept>

#include "adaptive_localization/particle/resampling.hpp"
#include "adaptive_localization/particle/summary.hpp"

namespace adaptive_localization {
namespace {

constexpr double kWorthWeighing = 1e-6;  // share of the fullest cell
constexpr double kWorthTelling = 1e-4;
constexpr std::size_t kMostSummarized = 20000;  // cells; of more, the cloud is
constexpr double kBytes = 60.0;                 // of a cell: held, and weighed as a particle is

/// Of what is uniform within a cell.
double withinCell(double side) {
  return side * side / 12.0;
}

}  // namespace

double sigmaInCells(double sigma_hit, const MarkovOptions& options) {
  constexpr double kRange = 3.0;  // m
  const double turn = kRange * 2.0 * kPi / options.markov_headings;
  constexpr double kMost = 10.0;  // of laser_sigma_hit, m
  return std::min(
      kMost, std::sqrt(sigma_hit * sigma_hit + withinCell(options.markov_cell) + withinCell(turn)));
}

MarkovFilter::MarkovFilter(const MarkovOptions& options, MarkovParts parts, std::uint64_t seed)
    : options_(options),
      parts_(std::move(parts)),
      belief_(parts_.map, options.markov_cell, options.markov_headings),
      rng_(seed) {
  summarizeBelief();
}

void MarkovFilter::reset(const Prior& prior) {
  pending_.finish();
  const auto* cloud = std::get_if<Particles>(&prior);
  if (cloud && cloud->size() > 0) {
    belief_.set(*cloud);
  } else if (const auto* gaussian = std::get_if<Gaussian2>(&prior)) {
    belief_.set(*gaussian);
  } else {
    belief_.spread();
  }
  summarizeBelief();
}

Estimate MarkovFilter::update(const Pose2& motion, const Observations& observations) {
  move(motion);
  if (belief_.cellsAbove(0.0).empty()) belief_.spread();  // it has left the map
  if (options_.markov_anywhere > 0.0) belief_.mix(options_.markov_anywhere);
  weigh(observations);
  summarizeBelief();
  pending_.finish();
  return estimate_;
}

/// Where memory runs out half-way, the belief goes on with the particles that were drawn from it.
void MarkovFilter::move(const Pose2& motion) {
  const Pose2 rest = pending_.rest(motion);
  pending_.move(motion);
  if (!isPlausible(rest)) return;
  try {
    belief_.move(rest, parts_.motion->covariance(rest));
  } catch (const std::bad_alloc&) {
    for (Eigen::Index i = 0; i < cloud_.size(); ++i) cloud_.setPose(i, cloud_.pose(i) * rest);
    belief_.set(cloud_);
    throw;
  }
}

void MarkovFilter::weigh(const Observations& observations) {
  const auto cells = belief_.cellsAbove(options_.markov_anywhere > 0.0 ? 0.0 : kWorthWeighing);
  const Particles poses = belief_.poses(cells);
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(poses.size());
  parts_.observation->score(observations, poses, log_likelihood);
  belief_.assign(cells, normalisedWeights(poses.log_weight + log_likelihood));
}

/// The estimate, and particles drawn within the cells that they stand for.
void MarkovFilter::summarizeBelief() {
  const auto cells = belief_.cellsAbove(kWorthTelling);
  const Particles poses = belief_.poses(cells);
  const Eigen::ArrayXd weights = normalisedWeights(poses.log_weight);
  cloud_ = select(poses, systematicIndices(weights, options_.cloud_particles, rng_));
  cloud_.log_weight.setConstant(-std::log(static_cast<double>(cloud_.size())));
  const bool are_few = cells.size() <= kMostSummarized;
  estimate_ =
      are_few ? summarize(poses, weights) : summarize(cloud_, normalisedWeights(cloud_.log_weight));
  const Eigen::Vector3d within(withinCell(belief_.cell()), withinCell(belief_.cell()),
                               withinCell(belief_.turn()));
  estimate_.covariance.diagonal() += within;
  for (Mode& mode : estimate_.modes) mode.covariance.diagonal() += within;
  for (Eigen::Index i = 0; i < cloud_.size(); ++i) {
    const double x = cloud_.x[i] + belief_.cell() * rng_.uniform(-0.5, 0.5);
    const double y = cloud_.y[i] + belief_.cell() * rng_.uniform(-0.5, 0.5);
    const double theta = wrapAngle(cloud_.theta[i] + belief_.turn() * rng_.uniform(-0.5, 0.5));
    if (parts_.map->isFree(parts_.map->lattice().cellAt({x, y}))) cloud_.setPose(i, {x, y, theta});
  }
}

void checkPriceOfCells(const MarkovOptions& options, const OccupancyGrid& map, int beams,
                       double price_of_beam) {
  constexpr double kMostLookUps = 5e9;  // 2.3 s of a core of 3 GHz
  const double cells = PoseHistogram::countCells(map, options.markov_cell, options.markov_headings);
  const double megabytes = cells * kBytes * 1e-6, look_ups = cells * beams * price_of_beam;
  if (megabytes <= options.markov_max_memory && look_ups <= kMostLookUps) return;
  std::ostringstream text;
  text << "option 'markov_cell': got '" << options.markov_cell << "', which with markov_headings "
       << options.markov_headings << " makes " << cells << " cells on this map: " << megabytes
       << " MB and " << look_ups << " look-ups for a scan, expected at most markov_max_memory, "
       << options.markov_max_memory << " MB, and " << kMostLookUps
       << " look-ups; larger cells, fewer headings or beams do";
  throw std::invalid_argument(text.str());
}

}  // namespace adaptive_localization
