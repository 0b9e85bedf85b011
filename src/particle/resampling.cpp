// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/particle/resampling.hpp"

#include <cmath>

#include "core/parts.hpp"

namespace adaptive_localization {
namespace {

constexpr double kCloseEnough = 1.1;  // times the effective particles that are wanted

/// For each of `count` shares of the weights' sum, which must ascend, the particle that holds it.
template <class Share>
std::vector<Eigen::Index> indicesAt(const Eigen::ArrayXd& weights, Eigen::Index count,
                                    const Share& share) {
  std::vector<Eigen::Index> indices;
  if (weights.size() == 0 || count <= 0) return indices;
  indices.reserve(static_cast<std::size_t>(count));
  double cumulative = weights[0];
  Eigen::Index i = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double target = share(k);
    while (target >= cumulative && i + 1 < weights.size()) cumulative += weights[++i];
    indices.push_back(i);
  }
  return indices;
}

}  // namespace

Eigen::ArrayXd normalisedWeights(const Eigen::ArrayXd& log_weight) {
  const Eigen::Index count = log_weight.size();
  if (count == 0) return {};
  Eigen::ArrayXd weights(count);
  const double most = log_weight.maxCoeff();
  forEachPart(count, [&](Eigen::Index first, Eigen::Index size) {
    weights.segment(first, size) = (log_weight.segment(first, size) - most).exp();
  });
  const double sum = sumOverParts<double>(count, [&](Eigen::Index first, Eigen::Index size) {
    return weights.segment(first, size).sum();
  });
  // one that is no number, an infinite one or only zeros make the sum none either
  if (!std::isfinite(sum)) return Eigen::ArrayXd::Constant(count, 1.0 / static_cast<double>(count));
  forEachPart(count,
              [&](Eigen::Index first, Eigen::Index size) { weights.segment(first, size) /= sum; });
  return weights;
}

Eigen::ArrayXd logOf(const Eigen::ArrayXd& weights) {
  Eigen::ArrayXd log_weight(weights.size());
  forEachPart(weights.size(), [&](Eigen::Index first, Eigen::Index size) {
    log_weight.segment(first, size) = weights.segment(first, size).log();
  });
  return log_weight;
}

double effectiveSize(const Eigen::ArrayXd& weights) {
  return 1.0 / weights.square().sum();
}

Eigen::ArrayXd temperedWeights(const Eigen::ArrayXd& weights, const Eigen::ArrayXd& log_likelihood,
                               double min_share) {
  const Eigen::ArrayXd log_weight = logOf(weights);
  const auto raised = [&](double exponent) {
    Eigen::ArrayXd posterior(weights.size());
    forEachPart(weights.size(), [&](Eigen::Index first, Eigen::Index size) {
      posterior.segment(first, size) =
          log_weight.segment(first, size) + exponent * log_likelihood.segment(first, size);
    });
    return normalisedWeights(posterior);
  };
  const double wanted = min_share * effectiveSize(weights);
  Eigen::ArrayXd posterior = raised(1.0);
  if (effectiveSize(posterior) >= wanted) return posterior;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 10; ++i) {
    const double middle = 0.5 * (low + high);
    posterior = raised(middle);
    const double kept = effectiveSize(posterior);
    if (kept >= wanted && kept <= kCloseEnough * wanted) return posterior;
    (kept >= wanted ? low : high) = middle;
  }
  return raised(low);
}

std::vector<Eigen::Index> systematicIndices(const Eigen::ArrayXd& weights, Eigen::Index count,
                                            Rng& rng) {
  if (weights.size() == 0 || count <= 0) return {};
  const double step = 1.0 / static_cast<double>(count);
  const double offset = rng.uniform();
  return indicesAt(weights, count,
                   [&](Eigen::Index k) { return (static_cast<double>(k) + offset) * step; });
}

std::vector<Eigen::Index> stratifiedIndices(const Eigen::ArrayXd& weights, Eigen::Index count,
                                            Rng& rng) {
  const double step = 1.0 / static_cast<double>(count);
  return indicesAt(weights, count,
                   [&](Eigen::Index k) { return (static_cast<double>(k) + rng.uniform()) * step; });
}

/// The smallest of n uniform numbers above x is 1 - (1 - x) u^(1/n): they come in order.
std::vector<Eigen::Index> multinomialIndices(const Eigen::ArrayXd& weights, Eigen::Index count,
                                             Rng& rng) {
  double rest = 1.0;
  return indicesAt(weights, count, [&](Eigen::Index k) {
    rest *= std::pow(rng.uniform(), 1.0 / static_cast<double>(count - k));
    return 1.0 - rest;
  });
}

Particles select(const Particles& particles, const std::vector<Eigen::Index>& indices) {
  Particles selected(static_cast<Eigen::Index>(indices.size()));
  forEachPart(selected.size(), [&](Eigen::Index first, Eigen::Index size) {
    for (Eigen::Index k = first; k < first + size; ++k) {
      selected.setPose(k, particles.pose(indices[static_cast<std::size_t>(k)]));
    }
  });
  return selected;
}

}  // namespace adaptive_localization
