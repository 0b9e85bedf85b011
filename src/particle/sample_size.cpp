// SPDX-License-Identifier: BSD-3-Clause
#include "particle/sample_size.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/pose_bins.hpp"

namespace adaptive_localization {
namespace {

class Fixed : public SampleSize {
 public:
  explicit Fixed(Eigen::Index size) : size_(size) {}
  Eigen::Index initial() const override { return size_; }
  Eigen::Index initial(const PoseSampler&, Rng&) const override { return size_; }
  Eigen::Index next(const Belief&, Rng&) override { return size_; }

 private:
  Eigen::Index size_;
};

/// Fox's algorithm: draw particles one by one until there are as many as the bins seen so far
/// demand. Only the number is kept; the set itself is then drawn systematically, with less
/// variance.
class KldDrawn : public SampleSize {
 public:
  explicit KldDrawn(const SampleSizeOptions& options) : options_(options) {}

  Eigen::Index initial() const override { return options_.max_particles; }

  Eigen::Index initial(const PoseSampler& region, Rng& rng) const override {
    return countDrawn([&]() { return region.draw(rng); });
  }

  Eigen::Index next(const Belief& belief, Rng& rng) override {
    std::vector<double> cumulative(static_cast<std::size_t>(belief.weights.size()));
    double sum = 0.0;
    for (std::size_t i = 0; i < cumulative.size(); ++i) {
      cumulative[i] = sum += belief.weights[static_cast<Eigen::Index>(i)];
    }
    return countDrawn([&]() {
      if (belief.elsewhere > 0.0 && rng.uniform() < belief.elsewhere) {
        return belief.sampler.draw(rng);
      }
      const auto at = std::upper_bound(cumulative.begin(), cumulative.end(), sum * rng.uniform());
      const auto i = std::min<Eigen::Index>(at - cumulative.begin(), belief.particles.size() - 1);
      return belief.particles.pose(i);
    });
  }

 protected:
  Eigen::Index sizeFor(int bins) const {
    return std::clamp<Eigen::Index>(kldSampleSize(bins, options_.kld_err, options_.kld_z),
                                    options_.min_particles, options_.max_particles);
  }

  /// How many poses are drawn until there are enough of them.
  template <class Draw>
  Eigen::Index countDrawn(const Draw& draw) const {
    PoseBins bins(options_.kld_bin_xy, options_.kld_bin_theta);
    Eigen::Index needed = options_.min_particles;
    for (Eigen::Index drawn = 1; drawn <= options_.max_particles; ++drawn) {
      const int before = bins.count();
      bins.add(draw());
      if (bins.count() > before) needed = sizeFor(bins.count());
      if (drawn >= needed) return drawn;
    }
    return options_.max_particles;
  }

  SampleSizeOptions options_;
};

/// The sources' reading: the bins of the set that was resampled size the next one, those of the
/// region elsewhere one that looks there.
class KldResampled : public KldDrawn {
 public:
  explicit KldResampled(const SampleSizeOptions& options)
      : KldDrawn(options), next_(options.max_particles) {}

  Eigen::Index next(const Belief& belief, Rng& rng) override {
    return belief.elsewhere > 0.0 ? std::max(next_, initial(belief.sampler, rng)) : next_;
  }

  void observe(const Particles& particles) override {
    PoseBins bins(options_.kld_bin_xy, options_.kld_bin_theta);
    bins.addAll(particles);
    next_ = sizeFor(bins.count());
  }

 private:
  Eigen::Index next_;
};

}  // namespace

Eigen::Index kldSampleSize(int bins, double err, double z) {
  if (bins <= 1) return 1;
  const double k = bins - 1;
  const double spread = 2.0 / (9.0 * k);
  return static_cast<Eigen::Index>(
      std::ceil(k / (2.0 * err) * std::pow(1.0 - spread + std::sqrt(spread) * z, 3)));
}

void orderLimits(const Parameters& given, Parameters& all) {
  const auto limits = all.read<SampleSizeOptions>();
  const bool has_most = given.has("max_particles");
  if (limits.min_particles <= limits.max_particles || given.has("min_particles") == has_most)
    return;
  const char* const other = has_most ? "min_particles" : "max_particles";
  all.set(other, OptionValue{has_most ? limits.max_particles : limits.min_particles});
}

std::unique_ptr<SampleSize> fixedSampleSize(const SampleSizeOptions& options) {
  return std::make_unique<Fixed>(options.max_particles);
}

std::unique_ptr<SampleSize> kldSampleSize(const SampleSizeOptions& options) {
  if (options.min_particles > options.max_particles) {
    throw std::invalid_argument(
        "option 'min_particles': got " + std::to_string(options.min_particles) +
        ", expected at most max_particles, which is " + std::to_string(options.max_particles));
  }
  if (options.kld_count == "resampled") return std::make_unique<KldResampled>(options);
  return std::make_unique<KldDrawn>(options);
}

}  // namespace adaptive_localization
