// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/motion/motion_model.hpp"

#include "adaptive_localization/motion/differential_drive.hpp"
#include "adaptive_localization/motion/omni_drive.hpp"

namespace adaptive_localization {

std::unique_ptr<MotionModel> makeMotionModel(const MotionOptions& options) {
  if (options.odom_model_type.compare(0, 4, "omni") == 0) {
    return std::make_unique<OmniDrive>(options);
  }
  return std::make_unique<DifferentialDrive>(options);
}

}  // namespace adaptive_localization
