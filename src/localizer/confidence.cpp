// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "match/pose_kalman.hpp"

namespace adaptive_localization {
namespace {

constexpr double kFit = 0.1, kMisfit = 0.3;  // m, of other senses: fits fully, not at all

}  // namespace

Confidence::Confidence(const ConfidenceOptions& options, std::shared_ptr<const DistanceField> field,
                       Senses senses)
    : options_(options), field_(std::move(field)), senses_(std::move(senses)) {
  if (options_.confidence_low_inliers >= options_.confidence_high_inliers) {
    throw std::invalid_argument("option 'confidence_low_inliers': got " +
                                std::to_string(options_.confidence_low_inliers) +
                                ", expected less than confidence_high_inliers, which is " +
                                std::to_string(options_.confidence_high_inliers));
  }
}

void Confidence::reset() {
  fit_ = -1.0;
  latest_fit_ = value_ = 0.0;
  contradictions_ = 0;
  is_contradicted_ = compact_ = ambiguous_ = false;
}

void Confidence::copyStateOf(const Confidence& other) {
  fit_ = other.fit_;
  value_ = other.value_;
  latest_fit_ = other.latest_fit_;
  contradictions_ = other.contradictions_;
  is_contradicted_ = other.is_contradicted_;
  compact_ = other.compact_;
  ambiguous_ = other.ambiguous_;
}

double Confidence::fitOf(const Pose2& T_map_base, const Scan& scan) const {
  const Transform2 to_map(T_map_base);
  int inliers = 0;
  for (Eigen::Index i = 0; i < scan.x.size(); ++i) {
    const Eigen::Vector2d hit(scan.x[i], scan.y[i]);
    if (field_->at(to_map * hit) < options_.confidence_inlier_distance) ++inliers;
  }
  const double share = static_cast<double>(inliers) / scan.hits();
  return std::clamp((share - options_.confidence_low_inliers) /
                        (options_.confidence_high_inliers - options_.confidence_low_inliers),
                    0.0, 1.0);
}

std::optional<double> Confidence::fitOf(const Pose2& T_map_base,
                                        const Observations& observations) const {
  if (observations.scan.hits() > 0) return fitOf(T_map_base, observations.scan);
  const auto misfit = senses_->misfit(observations, T_map_base);
  if (!misfit) return std::nullopt;
  return std::clamp((kMisfit - *misfit) / (kMisfit - kFit), 0.0, 1.0);
}

void Confidence::note(double fit) {
  latest_fit_ = fit;
  fit_ = fit_ < 0.0 ? fit : fit_ + options_.confidence_rate * (fit - fit_);
  contradictions_ = fit < kContradiction ? contradictions_ + 1 : 0;
}

void Confidence::contradict() {
  note(0.0);
}

void Confidence::observe(const Estimate& estimate, const Observations& observations) {
  if (const auto fit = fitOf(estimate.T_map_base, observations)) note(*fit);
  const double variance = estimate.covariance.topLeftCorner<2, 2>().trace();
  const double relative = variance / (options_.converged_std * options_.converged_std);
  compact_ = relative < 1.0;
  ambiguous_ = estimate.modes.size() > 1 && estimate.modes[1].mass >= options_.ambiguous_mass;
  const double mass = estimate.modes.empty() ? 0.0 : estimate.modes.front().mass;
  const Gaussian2 belief{estimate.T_map_base, estimate.covariance};
  is_contradicted_ = std::any_of(
      senses_->parts().begin(), senses_->parts().end(),
      [&](const auto& sense) { return areContradicting(*sense, observations, belief); });
  const double agreement = is_contradicted_ ? 0.5 : 1.0;
  value_ = std::clamp(fit() * agreement * mass / (1.0 + relative), 0.0, 1.0);
}

}  // namespace adaptive_localization
