// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/registry.hpp"
#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {

/// Normalised weights from their logarithms: sum 1. Weights that make no sense (all zero, or not a
/// number) become uniform.
Eigen::ArrayXd normalisedWeights(const Eigen::ArrayXd& log_weight);

/// Logarithms of weights: minus infinity where one is zero.
Eigen::ArrayXd logOf(const Eigen::ArrayXd& weights);

/// Effective number of particles, 1 / sum w^2, of normalised weights (Kong, Liu, Wong 1994).
double effectiveSize(const Eigen::ArrayXd& weights);

/// Normalised weights times the likelihood raised to the largest exponent in (0, 1] with which at
/// least this share of the effective particles is kept, or a tenth more (adaptive tempering, Jasra,
/// Stephens, Doucet, Tsagaris 2011), and normalised. The exponent is 1 where the likelihood is no
/// sharper than that, as in tracking; less for a sharp likelihood and a wide cloud, whose best
/// particles would else be taken for the only ones.
Eigen::ArrayXd temperedWeights(const Eigen::ArrayXd& weights, const Eigen::ArrayXd& log_likelihood,
                               double min_share);

/// Systematic resampling (Kitagawa 1996; Probabilistic Robotics, table 4.4): `count` indices, with
/// each particle i drawn floor or ceil of count w_i times. O(particles + count).
std::vector<Eigen::Index> systematicIndices(const Eigen::ArrayXd& weights, Eigen::Index count,
                                            Rng& rng);

/// Stratified resampling (Kitagawa 1996): as systematic, with a random number for each of the
/// `count` strata; particle i is drawn less than two times more or less often than count w_i.
std::vector<Eigen::Index> stratifiedIndices(const Eigen::ArrayXd& weights, Eigen::Index count,
                                            Rng& rng);

/// Multinomial resampling (Gordon, Salmond, Smith 1993), as amcl does: independent draws.
std::vector<Eigen::Index> multinomialIndices(const Eigen::ArrayXd& weights, Eigen::Index count,
                                             Rng& rng);

/// The particles at the indices, with equal weights.
Particles select(const Particles& particles, const std::vector<Eigen::Index>& indices);

/// How often each particle is drawn: `count` indices by normalised weights.
using Resampling = std::function<std::vector<Eigen::Index>(const Eigen::ArrayXd& weights,
                                                           Eigen::Index count, Rng& rng)>;

/// A resampling scheme as it is registered.
struct ResamplingDescription {
  std::string name;
  std::string sentence;
  std::function<Resampling(const Parameters& given)> make;
  std::vector<OptionDescription> options;  // all that make() reads
};

struct ResamplingChoice {
  std::string resampling_scheme{"systematic"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("resampling_scheme", resampling_scheme, Choices{},
           "How particles are drawn by their weights.");
  }
};

/// The scheme that the parameters name. Throws std::invalid_argument naming key and value.
inline Resampling makeResampling(const Registry<ResamplingDescription>& known,
                                 const Parameters& given) {
  return known.make(given.read<ResamplingChoice>().resampling_scheme, given);
}

}  // namespace adaptive_localization
