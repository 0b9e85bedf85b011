// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/pose2.hpp"
#include "adaptive_localization/core/registry.hpp"
#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {

/// What the built-in models read. Names and meanings are amcl's; odom_noise_* are ours.
struct MotionOptions {
  double odom_alpha1{0.1};
  double odom_alpha2{0.1};
  double odom_alpha3{0.02};
  double odom_alpha4{0.01};
  double odom_alpha5{0.1};
  double odom_noise_xy{0.01};
  double odom_noise_theta{0.005};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("odom_alpha1", odom_alpha1, Range{0, 100}, "", "Rotation noise from rotation.");
    option("odom_alpha2", odom_alpha2, Range{0, 100}, "rad^2/m^2",
           "Rotation noise from translation.");
    option("odom_alpha3", odom_alpha3, Range{0, 100}, "", "Translation noise from translation.");
    option("odom_alpha4", odom_alpha4, Range{0, 100}, "m^2/rad^2",
           "Translation noise from rotation.");
    option("odom_alpha5", odom_alpha5, Range{0, 100}, "",
           "Sideways noise from translation (omni).");
    option("odom_noise_xy", odom_noise_xy, kDeviation, "m",
           "Standard deviation added to x and to y at each update, whatever the motion.");
    option("odom_noise_theta", odom_noise_theta, kDeviation, "rad",
           "Standard deviation added to the heading at each update, whatever the motion.");
  }
};

/// Whether odometry can mean it: numbers, and less than 10 km since the last update.
inline bool isPlausible(const Pose2& motion) {
  return isFinite(motion) && std::hypot(motion.x, motion.y) < 1e4;
}

/// How the robot moves when odometry says it moved by T_previous_current. One noise model, either
/// sampled or as a Gaussian.
class MotionModel {
 public:
  virtual ~MotionModel() = default;

  /// Moves every particle by the motion and a sample of its noise. Same bits for any number of
  /// threads: chunks of fixed size draw from their own streams of rng.
  virtual void propagate(const Pose2& motion, Particles& particles, Rng& rng) const = 0;

  /// Covariance of the motion's noise over (x, y, theta) in the frame of the previous pose, to
  /// first order.
  virtual Eigen::Matrix3d covariance(const Pose2& motion) const = 0;
};

/// What the alphas give: variances, or what amcl's older models take them for, the standard
/// deviations themselves.
enum class NoiseRule { kVariances, kDeviations };

/// A motion model as it is registered.
struct MotionDescription {
  std::string name;
  std::string sentence;
  std::function<std::unique_ptr<MotionModel>(const Parameters& given)> make;
  std::vector<OptionDescription> options;  // all that make() reads
};

struct MotionChoice {
  std::string odom_model_type{"diff-corrected"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("odom_model_type", odom_model_type, Choices{},
           "Motion model; the ones without '-corrected' take variances for standard deviations, as "
           "amcl's do.");
  }
};

/// The model that the parameters name. Throws std::invalid_argument naming key and value.
inline std::unique_ptr<MotionModel> makeMotionModel(const Registry<MotionDescription>& known,
                                                    const Parameters& given) {
  return known.make(given.read<MotionChoice>().odom_model_type, given);
}

}  // namespace adaptive_localization
