// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace adaptive_localization {

/// What a swarm minimises.
class Objective {
 public:
  virtual ~Objective() = default;

  /// The costs of positions, one in each row. One virtual call per iteration of the swarm.
  virtual void evaluate(const Eigen::ArrayXXd& positions,
                        Eigen::Ref<Eigen::ArrayXd> costs) const = 0;
};

}  // namespace adaptive_localization
