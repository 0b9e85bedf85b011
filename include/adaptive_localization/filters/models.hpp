// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/registry.hpp"
#include "adaptive_localization/motion/motion_model.hpp"
#include "adaptive_localization/observation/observation_model.hpp"
#include "adaptive_localization/particle/resampling.hpp"

namespace adaptive_localization {

/// The models that filters are put together from, by name.
struct Models {
  Registry<MotionDescription> motions{"odom_model_type"};
  Registry<ObservationDescription> observations{"laser_model_type"};
  Registry<ResamplingDescription> resamplings{"resampling_scheme"};

  /// Of the senses beside the laser: all are listened to.
  Registry<ObservationDescription> senses{"sense"};
};

}  // namespace adaptive_localization
