// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/start.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace adaptive_localization {
namespace {

Gaussian2 around(const Pose2& mean, const StartOptions& options) {
  Gaussian2 prior;
  prior.mean = mean;
  prior.covariance.diagonal() << options.initial_cov_xx, options.initial_cov_yy,
      options.initial_cov_aa;
  return prior;
}

bool hasReference(const LogScan& scan) {
  return scan.T_map_base.has_value();
}

Pose2 firstReference(Log& log) {
  const auto first = std::find_if(log.scans.begin(), log.scans.end(), hasReference);
  if (first == log.scans.end()) {
    throw std::invalid_argument(
        "--start truth: no reference at any scan; give one with --truth or --truth-topic");
  }
  if (const auto early = first - log.scans.begin(); early > 0) {
    log.warnings.push_back(std::to_string(early) +
                           " scans before the reference begins are not used");
  }
  log.scans.erase(log.scans.begin(), first);
  return *log.scans.front().T_map_base;
}

Pose2 parsePose(const std::string& text) {
  std::istringstream fields(text);
  Pose2 pose;
  char comma1{}, comma2{}, rest{};
  const bool is_read =
      static_cast<bool>(fields >> pose.x >> comma1 >> pose.y >> comma2 >> pose.theta);
  if (!is_read || comma1 != ',' || comma2 != ',' || fields >> rest || !isFinite(pose)) {
    throw std::invalid_argument("--start: got '" + text +
                                "', expected truth, global or X,Y,YAW in m and rad");
  }
  return {pose.x, pose.y, wrapAngle(pose.theta)};
}

}  // namespace

Prior startPrior(const std::string& start, const StartOptions& options, Log& log) {
  const bool has_reference = std::any_of(log.scans.begin(), log.scans.end(), hasReference);
  if (start == "global" || (start.empty() && !has_reference)) return Anywhere{};
  if (start == "truth" || start.empty()) return around(firstReference(log), options);
  return around(parsePose(start), options);
}

}  // namespace adaptive_localization
