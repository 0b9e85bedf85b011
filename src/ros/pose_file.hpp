// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "adaptive_localization/core/belief.hpp"

namespace adaptive_localization {

/// Reads a pose written by writePoseFile; nothing if there is no such file.
/// Throws std::invalid_argument naming the file and what is wrong with it.
std::optional<Gaussian2> readPoseFile(const std::string& path);

/// Writes a pose as YAML, in initial_pose_* and initial_cov_*. The old file stands until the new
/// one is on the disk, so that a power failure leaves one of the two. Throws std::runtime_error
/// naming the file and why it cannot be written.
void writePoseFile(const std::string& path, const Gaussian2& pose);

}  // namespace adaptive_localization
