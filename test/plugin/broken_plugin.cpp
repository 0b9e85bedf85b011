// SPDX-License-Identifier: BSD-3-Clause
// Libraries that are no good as plug-ins, one for each value of BROKEN.
#include "adaptive_localization/filters/registries.hpp"

#if BROKEN == 1  // the entry point is a variable
extern "C" {
int adaptive_localization_register_v2 = 1;
}
#elif BROKEN == 2  // it throws what is no std::exception, when it has added something
extern "C" void adaptive_localization_register_v2(adaptive_localization::Registries& registries);
void adaptive_localization_register_v2(adaptive_localization::Registries& registries) {
  registries.filters.add({"half",
                          "",
                          [](const adaptive_localization::FilterContext&) { return nullptr; },
                          {},
                          {},
                          {}});
  throw 42;
}
#elif BROKEN == 3  // its filter's estimate is not a number
#include <limits>
#include <memory>

namespace {

using namespace adaptive_localization;  // as a library of someone else would

class Nowhere : public Filter {
 public:
  void reset(const Prior&) override {}
  Estimate update(const Pose2&, const Observations&) override { return estimate(); }
  Estimate estimate() const override {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    return {{kNaN, kNaN, kNaN}, Eigen::Matrix3d::Identity(), {}};
  }
  const Particles& hypotheses() const override { return particles_; }

 private:
  Particles particles_{1};
};

}  // namespace

extern "C" void adaptive_localization_register_v2(Registries& registries);
void adaptive_localization_register_v2(Registries& registries) {
  registries.filters.add(
      {"nowhere",
       "Lost.",
       [](const FilterContext&) -> std::unique_ptr<Filter> { return std::make_unique<Nowhere>(); },
       {},
       {},
       {}});
}
#elif BROKEN == 4  // it is of an older version
extern "C" void adaptive_localization_register_filters_v1(void*);
void adaptive_localization_register_filters_v1(void*) {}
#endif
