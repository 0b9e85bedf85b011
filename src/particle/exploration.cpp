// SPDX-License-Identifier: BSD-3-Clause
#include "particle/exploration.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

class None : public Exploration {
 public:
  void reset() override {}
  void observe(const Evidence&) override {}
  double share() const override { return 0.0; }
};

class Augmented : public Exploration {
 public:
  explicit Augmented(const ExplorationOptions& options) : options_(options) {}

  void reset() override { w_slow_ = w_fast_ = 0.0; }

  void observe(const Evidence& evidence) override {
    const double w = evidence.mean_likelihood;
    if (!std::isfinite(w)) return;
    if (w_slow_ <= 0.0) w_slow_ = w_fast_ = w;
    w_slow_ += options_.recovery_alpha_slow * (w - w_slow_);
    w_fast_ += options_.recovery_alpha_fast * (w - w_fast_);
    if (isBest()) w_slow_ = std::max(w_slow_, w_fast_);
  }

  double share() const override {
    const bool on = options_.recovery_alpha_slow > 0.0 && options_.recovery_alpha_fast > 0.0;
    if (!on || w_slow_ <= 0.0) return 0.0;
    return std::max(0.0, 1.0 - options_.recovery_margin * w_fast_ / w_slow_);
  }

  void explored() override {
    if (!isBest()) reset();
  }

 private:
  bool isBest() const { return options_.recovery_reference == "best"; }

  ExplorationOptions options_;
  double w_slow_{0.0};
  double w_fast_{0.0};
};

}  // namespace

std::unique_ptr<Exploration> noExploration() {
  return std::make_unique<None>();
}

std::unique_ptr<Exploration> augmentedExploration(const ExplorationOptions& options) {
  return std::make_unique<Augmented>(options);
}

}  // namespace adaptive_localization
