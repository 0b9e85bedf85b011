// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/log.hpp"

namespace adaptive_localization {
namespace {

constexpr double kLongestGap = 1.0;      // s; a reference is not interpolated further
constexpr double kStampRounding = 1e-6;  // s

}  // namespace

bool isWanted(double stamp, const LogRequest& request) {
  return stamp >= request.begin - kStampRounding && stamp <= request.end + kStampRounding;
}

void setReference(const Trajectory& reference, Log& log) {
  for (auto& scan : log.scans) scan.T_map_base = reference.at(scan.scan.stamp, kLongestGap);
}

}  // namespace adaptive_localization
