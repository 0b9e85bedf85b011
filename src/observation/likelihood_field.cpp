// SPDX-License-Identifier: BSD-3-Clause
#include "observation/likelihood_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/pose_bins.hpp"
#include "missed_walls.hpp"
#include "score_field.hpp"

namespace adaptive_localization {
namespace {

/// Of more particles each gets too few rays, and they take too long.
constexpr Eigen::Index kMostForRays = 20000;

/// amcl's test that the cloud is compact enough for skipping beams: within half a metre of its
/// mean.
bool isCompact(const Particles& particles) {
  const auto within = [](const Eigen::ArrayXd& column) {
    return ((column - column.mean()).abs() <= 0.5).all();
  };
  return particles.size() > 0 && within(particles.x) && within(particles.y);
}

/// Whether a bin of half a metre and 10 degrees holds fewer than 30 particles on average. Every
/// eighth particle tells: where it matters, hardly a bin has none of those.
bool isSparse(const Particles& particles) {
  constexpr int kPerBin = 30;
  PoseBins bins(0.5, kPi / 18.0);
  const auto most = static_cast<int>(particles.size() / kPerBin);
  for (Eigen::Index i = 0; i < particles.size() && bins.count() <= most; i += 8) {
    bins.add(particles.pose(i));
  }
  return bins.count() > most;
}

}  // namespace

LikelihoodField::LikelihoodField(const ObservationOptions& options, Form form,
                                 std::shared_ptr<const DistanceField> field)
    : options_(options), form_(form), field_(std::move(field)) {
  options_.laser_sigma_hit = sigmaHit(options, field_->quality());
  if (options_.do_beamskip && form_ == Form::kSum) {
    // a field of its own: the likelihood is flat long before the distance that explains a hit
    nearness_ = std::make_unique<ScoreField>(
        field_, 2.0 * options_.beam_skip_distance, [](double distance) { return -distance; },
        ScoreField::Table::kNone);
  }
}

LikelihoodField::~LikelihoodField() = default;

double LikelihoodField::likelihood(double distance, double max_range, double sigma) const {
  const double deviations = distance / sigma;
  const double p = options_.laser_z_hit * std::exp(-0.5 * deviations * deviations) +
                   options_.laser_z_rand / max_range;
  return std::max(p, 1e-12);  // both weights may be zero
}

std::unique_ptr<ScoreField> LikelihoodField::fieldOf(double max_range, bool is_sparse) const {
  const double sigma = is_sparse ? options_.laser_sigma_sparse : options_.laser_sigma_hit;
  const auto value = [&](double distance) {
    const double p = likelihood(distance, max_range, sigma);
    return form_ == Form::kCubed ? p * p * p : std::log(p);
  };
  return std::make_unique<ScoreField>(
      field_, options_.laser_likelihood_max_dist, value,
      is_sparse ? ScoreField::Table::kNone : ScoreField::Table::kKept);
}

const ScoreField& LikelihoodField::fieldFor(double max_range, const Particles& particles) const {
  const bool is_sparse =
      options_.laser_sigma_sparse > options_.laser_sigma_hit && isSparse(particles);
  constexpr std::size_t kMostLasers = 4;  // as many fields: a driver may send ever new limits
  if (fields_.size() >= kMostLasers && fields_.count(max_range) == 0) fields_.clear();
  Fields& fields = fields_[max_range];
  std::unique_ptr<ScoreField>& field = is_sparse ? fields.sparse : fields.dense;
  if (!field) field = fieldOf(max_range, is_sparse);
  return *field;
}

Scan LikelihoodField::skipBeams(const Scan& scan, const Particles& particles) const {
  const Eigen::ArrayXd share =
      nearness_->shareAbove(-options_.beam_skip_distance, scan.x, scan.y, particles);
  const auto used = (share > options_.beam_skip_threshold).count();
  const double skipped = 1.0 - static_cast<double>(used) / static_cast<double>(scan.hits());
  if (skipped >= options_.beam_skip_error_threshold) return scan;

  Scan kept = scan;
  Eigen::Index next = 0;
  for (Eigen::Index j = 0; j < scan.x.size(); ++j) {
    if (share[j] <= options_.beam_skip_threshold) continue;
    kept.x[next] = scan.x[j];
    kept.y[next++] = scan.y[j];
  }
  kept.x.conservativeResize(next);
  kept.y.conservativeResize(next);
  return kept;
}

/// Of a beam that sees nothing where the map has a wall. Where the map has what is not there, such
/// beams are many at the true pose as well, and each tells less: this share of them is usual.
double LikelihoodField::logOfMiss(double usual) const {
  constexpr double kLeast = 0.01;  // glass, or a wall that is gone, is never out of the question
  return std::log(std::max({kLeast, options_.laser_z_max, usual}));
}

double LikelihoodField::score(const Observations& observations, const Particles& particles,
                              Eigen::Ref<Eigen::ArrayXd> log_likelihood) const {
  std::optional<Scan> thinner;
  if (nearness_ && observations.scan.hits() > 0 && isCompact(particles)) {
    thinner = skipBeams(observations.scan, particles);
  }
  const Scan& scan = thinner ? *thinner : observations.scan;
  const int hits = scan.hits();
  if (hits == 0 || particles.size() == 0) return 0.0;

  Eigen::ArrayXd sums(particles.size());
  fieldFor(scan.max_range, particles).sum(scan.x, scan.y, particles, sums);
  if (form_ == Form::kCubed) {
    log_likelihood += sums.log1p();
    return 1.0;
  }
  double beams = hits;
  if (form_ == Form::kTempered && isMostlyOpen(scan) && particles.size() <= kMostForRays) {
    const auto open = static_cast<double>(scan.no_return_bearing.size());
    const Eigen::ArrayXd missed = missedWalls(scan, particles, *field_);
    sums += logOfMiss(missed.mean() / open) * missed;
    beams += open;
  }
  const double independent = form_ == Form::kSum ? hits : std::min(beams, options_.effective_beams);
  log_likelihood += sums * (independent / beams);
  return independent;
}

}  // namespace adaptive_localization
