// SPDX-License-Identifier: BSD-3-Clause
#include "confidence_history.hpp"

#include <algorithm>

namespace adaptive_localization {
namespace {

constexpr double kStep = 0.25;  // s, between samples that are kept
constexpr double kJump = 1.0;   // s

}  // namespace

void ConfidenceHistory::add(const Sample& sample) {
  if (!samples_.empty() && sample.stamp < newest_ - kJump) samples_.clear();
  if (!samples_.empty() && sample.stamp < newest_) return;
  newest_ = sample.stamp;
  const bool is_change = samples_.empty() || samples_.back().status != sample.status;
  if (is_change) status_since_ = sample.stamp;
  if (is_change || sample.stamp - samples_.back().stamp >= kStep) {
    samples_.push_back(sample);
  } else {
    samples_.back().confidence = std::min(samples_.back().confidence, sample.confidence);
  }
  while (samples_.front().stamp < newest_ - kSpan) samples_.pop_front();
}

double ConfidenceHistory::secondsInStatus() const {
  return samples_.empty() ? 0.0 : newest_ - status_since_;
}

}  // namespace adaptive_localization
