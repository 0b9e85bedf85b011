// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/observation/composed_model.hpp"

#include <gmock/gmock.h>

namespace adaptive_localization {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// Adds a slope over x, and observes x.
class Slope : public ObservationModel {
 public:
  explicit Slope(double slope) : slope_(slope) {}

  double score(const Observations&, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override {
    log_likelihood += slope_ * particles.x;
    return 2.0;
  }

  std::vector<PoseObservation> linearized(const Observations&, const Pose2& pose) const override {
    PoseObservation seen;
    seen.innovation.setConstant(1, slope_ - pose.x);
    seen.H = Eigen::RowVector3d::UnitX();
    seen.R.setConstant(1, 1, 1.0);
    return {seen};
  }

 private:
  double slope_;
};

Particles twoParticles() {
  Particles particles(2);
  particles.setPose(0, {1.0, 0.0, 0.0});
  particles.setPose(1, {2.0, 0.0, 0.0});
  return particles;
}

TEST(ComposedModel, IsTheProductOfItsParts) {
  ComposedModel model;
  model.add(std::make_unique<Slope>(3.0));
  model.add(std::make_unique<Slope>(-1.0));
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Constant(2, 10.0);
  EXPECT_EQ(model.score({}, twoParticles(), log_likelihood), 4.0);
  EXPECT_DOUBLE_EQ(log_likelihood[0], 12.0);
  EXPECT_DOUBLE_EQ(log_likelihood[1], 14.0);
  const auto seen = model.linearized({}, {1.0, 0.0, 0.0});
  ASSERT_THAT(seen, SizeIs(2));
  EXPECT_DOUBLE_EQ(seen[0].innovation[0], 2.0);
  EXPECT_DOUBLE_EQ(seen[1].innovation[0], -2.0);
}

TEST(ComposedModel, OfNothingSaysNothing) {
  Eigen::ArrayXd log_likelihood = Eigen::ArrayXd::Zero(2);
  EXPECT_EQ(noSenses()->score({}, twoParticles(), log_likelihood), 0.0);
  EXPECT_TRUE((log_likelihood == 0.0).all());
  EXPECT_THAT(noSenses()->linearized({}, {}), IsEmpty());
}

}  // namespace
}  // namespace adaptive_localization
