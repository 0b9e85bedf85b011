// SPDX-License-Identifier: BSD-3-Clause
// Models that live in a library of their own: how a robot on tracks moves, how well a scan fits,
// another sense, and who survives.
#include "adaptive_localization/filters/registries.hpp"

namespace {

using namespace adaptive_localization;  // as a library of someone else would

struct SkidSteerOptions {
  double gain{1.0};
  double noise{0.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("skid_steer_gain", gain, Range{0.5, 2.0}, "",
           "What a radian of odometry is in radians.");
    option("skid_steer_noise", noise, kDeviation, "rad", "Standard deviation of a turn.");
  }
};

class SkidSteer : public MotionModel {
 public:
  explicit SkidSteer(const SkidSteerOptions& options) : options_(options) {}

  void propagate(const Pose2& motion, Particles& particles, Rng& rng) const override {
    for (Eigen::Index i = 0; i < particles.size(); ++i) {
      const double turn = options_.gain * motion.theta + options_.noise * rng.normal();
      particles.setPose(i, particles.pose(i) * Pose2{motion.x, motion.y, turn});
    }
  }

  Eigen::Matrix3d covariance(const Pose2&) const override {
    return Eigen::Vector3d(1e-4, 1e-4, options_.noise * options_.noise).asDiagonal();
  }

 private:
  SkidSteerOptions options_;
};

struct InlierOptions {
  double distance{0.1};
  double weight{20.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("inlier_distance", distance, Range{0.01, 1.0}, "m", "A hit nearer to a wall fits.");
    option("inlier_weight", weight, Range{0.0, 100.0}, "", "Log likelihood if all hits fit.");
  }
};

/// The share of the hits that are near walls.
class Inliers : public ObservationModel {
 public:
  Inliers(const InlierOptions& options, std::shared_ptr<const DistanceField> field)
      : options_(options), field_(std::move(field)) {}

  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override {
    const Scan& scan = observations.scan;
    if (scan.hits() == 0) return 0.0;
    for (Eigen::Index i = 0; i < particles.size(); ++i) {
      int inliers = 0;
      for (Eigen::Index j = 0; j < scan.x.size(); ++j) {
        const Eigen::Vector2d hit(scan.x[j], scan.y[j]);
        if (field_->at(particles.pose(i) * hit) < options_.distance) ++inliers;
      }
      log_likelihood[i] += options_.weight * inliers / scan.hits();
    }
    return 1.0;
  }

 private:
  InlierOptions options_;
  std::shared_ptr<const DistanceField> field_;
};

struct GateOptions {
  double x{100.0};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("gate_x", x, Range{-100.0, 100.0}, "m", "No robot passes this.");
  }
};

/// A gate that is shut: needs nothing observed to know where the robot is not.
class Gate : public ObservationModel {
 public:
  explicit Gate(const GateOptions& options) : options_(options) {}

  double score(const Observations&, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override {
    log_likelihood +=
        (particles.x > options_.x).select(-20.0, Eigen::ArrayXd::Zero(particles.size()));
    return 1.0;
  }

 private:
  GateOptions options_;
};

std::vector<Eigen::Index> heaviest(const Eigen::ArrayXd& weights, Eigen::Index count, Rng&) {
  Eigen::Index best = 0;
  weights.maxCoeff(&best);
  return std::vector<Eigen::Index>(static_cast<std::size_t>(count), best);
}

}  // namespace

extern "C" void adaptive_localization_register_v2(Registries& registries) {
  registries.motions.add({"skid_steer", "A robot on tracks, which slip in turns.",
                          [](const Parameters& given) {
                            return std::make_unique<SkidSteer>(given.read<SkidSteerOptions>());
                          },
                          describe(SkidSteerOptions{})});
  registries.observations.add(
      {"inliers", "The share of the hits that are near walls.",
       [](const Parameters& given, const auto&, const std::shared_ptr<const DistanceField>& field) {
         return std::make_unique<Inliers>(given.read<InlierOptions>(), field);
       },
       describe(InlierOptions{})});
  registries.senses.add({"gate", "Where a gate is shut.",
                         [](const Parameters& given, const auto&, const auto&) {
                           return std::make_unique<Gate>(given.read<GateOptions>());
                         },
                         describe(GateOptions{})});
  registries.resamplings.add({"heaviest",
                              "The heaviest particle and nobody else.",
                              [](const Parameters&) -> Resampling { return heaviest; },
                              {}});
}
