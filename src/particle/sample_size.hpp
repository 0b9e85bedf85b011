// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/rng.hpp"
#include "particle/pose_sampler.hpp"

namespace adaptive_localization {

struct SampleSizeOptions {
  int min_particles{500};
  int max_particles{20000};
  double kld_err{0.02};
  double kld_z{2.33};
  double kld_bin_xy{0.5};
  double kld_bin_theta{kPi / 18.0};
  std::string kld_count{"drawn"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("min_particles", min_particles, Range{1, 1000000}, "", "Fewest particles (KLD).");
    option("max_particles", max_particles, Range{1, 1000000}, "",
           "Most particles (KLD); the number of particles (fixed size).");
    option("kld_err", kld_err, Range{1e-6, 1}, "",
           "Largest Kullback-Leibler divergence of the particles from the true belief.");
    option("kld_z", kld_z, Range{0, 10}, "",
           "Standard normal quantile of the probability that kld_err holds: 2.33 for 99 %.");
    option("kld_bin_xy", kld_bin_xy, Range{1e-3, 100}, "m", "Side of a bin in x and y (KLD).");
    option("kld_bin_theta", kld_bin_theta, Range{1e-3, 2 * kPi}, "rad",
           "Side of a bin in heading (KLD); 2 pi: bins in x and y only.");
    option("kld_count", kld_count, Choices{"drawn", "resampled"},
           "Set whose bins give the sample size: the one being drawn (Fox 2003), or the last "
           "resampled one (Li 2016).");
  }
};

/// Of the limits min_particles and max_particles, one that was not given gives way to the other.
/// `all` has the given values and those of a preset.
void orderLimits(const Parameters& given, Parameters& all);

/// Particles needed so that with probability 1 - delta the Kullback-Leibler divergence between the
/// sample and the belief is at most err, when the belief fills `bins` bins (Fox, Adapting the
/// sample size in particle filters through KLD-sampling, IJRR 2003, eq. 7; the Wilson-Hilferty
/// form):
///
///     n = (k - 1) / (2 err) (1 - 2 / (9 (k - 1)) + sqrt(2 / (9 (k - 1))) z)^3,   k > 1
///
/// z is the upper 1 - delta quantile of the standard normal. Rounded up; 1 for k <= 1.
Eigen::Index kldSampleSize(int bins, double err, double z);

/// What the next set is drawn from: particles with normalised weights, and with the probability
/// `elsewhere` a pose of the sampler.
struct Belief {
  const Particles& particles;
  const Eigen::ArrayXd& weights;
  const PoseSampler& sampler;
  double elsewhere;
};

/// How many particles the next set shall have.
class SampleSize {
 public:
  virtual ~SampleSize() = default;

  /// For a set that starts anew.
  virtual Eigen::Index initial() const = 0;

  /// For a set that starts anew in the region that a sampler draws from.
  virtual Eigen::Index initial(const PoseSampler& region, Rng& rng) const = 0;

  /// For a set drawn from a belief.
  virtual Eigen::Index next(const Belief& belief, Rng& rng) = 0;

  /// Told of each new set: one that starts anew, or one just resampled.
  virtual void observe(const Particles&) {}
};

std::unique_ptr<SampleSize> fixedSampleSize(const SampleSizeOptions& options);

/// KLD-sampling. A set that starts in a region has as many particles as the bins that the region
/// occupies ask for (SA-KLD).
/// Throws std::invalid_argument if min_particles exceeds max_particles.
std::unique_ptr<SampleSize> kldSampleSize(const SampleSizeOptions& options);

}  // namespace adaptive_localization
