// SPDX-License-Identifier: BSD-3-Clause
#include "experiment_judge.hpp"

#include <algorithm>
#include <cmath>

#include "eval/metrics.hpp"
#include "eval/statistics.hpp"

namespace adaptive_localization {
namespace {

constexpr double kDegrees = 180.0 / kPi;
constexpr double kSoon = 1e-6;  // s

double headingError(const Pose2& a, const Pose2& b) {
  return std::abs(wrapAngle(a.theta - b.theta));
}

bool isNear(const Pose2& a, const Pose2& b, double position, double heading) {
  return distance(a, b) < position && headingError(a, b) < heading;
}

bool isWrong(const Pose2& estimate, const Pose2& truth) {
  return !isNear(estimate, truth, kLostDistance, kLostHeading);
}

bool hasMode(const std::vector<Mode>& modes, const Pose2& pose) {
  return std::any_of(modes.begin(), modes.end(),
                     [&](const Mode& mode) { return !isWrong(mode.T_map_base, pose); });
}

Pose2 turnedHalf(const Pose2& centre, const Pose2& pose) {
  return {2.0 * centre.x - pose.x, 2.0 * centre.y - pose.y, wrapAngle(pose.theta + kPi)};
}

}  // namespace

void ExperimentJudge::Held::note(bool holds, double stamp) {
  if (!holds) {
    scans = 0;
  } else if (scans++ == 0) {
    since = stamp;
  }
}

void ExperimentJudge::begin(Trial::Kind kind, double at, const Pose2& T_map_base) {
  endTrial();
  Trial trial;
  trial.kind = kind;
  trial.at = at;
  trial.T_map_base = T_map_base;
  trial.within_s = rule_.within;
  result_.trials.push_back(trial);
  has_trial_ = true;
}

void ExperimentJudge::endTrial() {
  has_trial_ = is_settled_ = false;
  right_ = told_ = silent_ = {};
}

/// The one that the estimate is nearer to, where the twin of the true place counts as well.
std::optional<Pose2> ExperimentJudge::truthFor(const JudgedScan& scan) const {
  if (!scan.T_map_base || !rule_.is_modulo || !half_turn_) return scan.T_map_base;
  const Pose2 twin = turnedHalf(*half_turn_, *scan.T_map_base);
  const auto off = [&](const Pose2& pose) {
    return distance(pose, scan.answer.T_map_base) + headingError(pose, scan.answer.T_map_base);
  };
  return off(twin) < off(*scan.T_map_base) ? twin : scan.T_map_base;
}

void ExperimentJudge::observe(const JudgedScan& all) {
  JudgedScan scan = all;
  scan.T_map_base = truthFor(all);
  const bool is_tracking = scan.answer.status == Status::kTracking;
  ++result_.scans;
  ++result_.status[toText(scan.answer.status)];
  if (before_) result_.duration_s += scan.stamp - before_->stamp;
  if (scan.answer.updated) {
    if (result_.updates++ == 0) result_.particles_first = scan.particles;
    times_.push_back(scan.update_ms);
    counts_.push_back(scan.particles);
    result_.looks_elsewhere += scan.answer.estimate.share_elsewhere > 0.0;
  }
  while (scan.stamp + kSoon >= static_cast<double>(result_.particles_by_s.size()))
    result_.particles_by_s.push_back(scan.particles);
  noteAlarms(scan);
  noteModes(scan);
  if (scan.T_map_base) {
    noteTrial(scan,
              isNear(scan.answer.T_map_base, *scan.T_map_base, rule_.position, rule_.heading));
    noteValid(scan);
    noteWrong(scan);
    noteProbes(scan);
    result_.calibration.note(scan.answer.confidence,
                             distance(scan.answer.T_map_base, *scan.T_map_base));
  } else {
    ++result_.carried;
    result_.carried_tracking += is_tracking;
  }
  before_ = scan;
}

void ExperimentJudge::noteTrial(const JudgedScan& scan, bool is_right) {
  if (!has_trial_) return;
  Trial& trial = result_.trials.back();
  const Status status = scan.answer.status;
  ++trial.scans;
  if (!is_right && !trial.found_s) {
    ++trial.searching;
    trial.searching_tracking += status == Status::kTracking;
    const bool is_late = rule_.within && scan.stamp - trial.at > *rule_.within + kSoon;
    trial.late_tracking += is_late && status == Status::kTracking;
    trial.searching_ambiguous += status == Status::kAmbiguous;
  }
  right_.note(is_right, scan.stamp);
  told_.note(is_right && status == Status::kTracking, scan.stamp);
  if (right_.scans == rule_.scans && !trial.found_s) trial.found_s = right_.since - trial.at;
  if (told_.scans == rule_.scans && !trial.told_s) trial.told_s = told_.since - trial.at;
  is_settled_ = is_settled_ || trial.told_s.has_value();

  const double error = distance(scan.answer.T_map_base, *scan.T_map_base);
  const double heading_error = headingError(scan.answer.T_map_base, *scan.T_map_base);
  if (trial.found_s) {
    errors_m_.push_back(error);
    errors_rad_.push_back(heading_error);
    accuracy_.observe(scan.stamp, scan.answer, *scan.T_map_base, scan.bounds);
  }
  const bool is_wrong = isWrong(scan.answer.T_map_base, *scan.T_map_base);
  const bool was_right = trial.found_s || trial.kind == Trial::Kind::kKnownStart;
  if (is_wrong && was_right && !trial.left_s) trial.left_s = scan.stamp - trial.at;
  trial.end_status = toText(status);
  trial.end_error_m = error;
  trial.end_error_deg = kDegrees * heading_error;
  trial.is_silent_failure = status == Status::kTracking && is_wrong;
}

void ExperimentJudge::noteValid(const JudgedScan& scan) {
  if (!has_trial_ || !scan.spread || *scan.spread > kValidSpread) return;
  Trial& trial = result_.trials.back();
  if (trial.validated_s) return;
  if (isWrong(scan.answer.T_map_base, *scan.T_map_base)) {
    ++trial.wrongly_validated;
  } else {
    trial.validated_s = scan.stamp - trial.at;
  }
}

void ExperimentJudge::noteAlarms(const JudgedScan& scan) {
  if (!before_) return;
  const Pose2 expected = before_->answer.T_map_odom * scan.T_odom_base;
  const bool has_jumped =
      before_->answer.status != Status::kUninitialised && isWrong(scan.answer.T_map_base, expected);
  result_.jumps += has_jumped;
  if (!scan.T_map_base) result_.carried_jumps += has_jumped;
  if (!is_settled_ || !scan.T_map_base) return;
  result_.settled_s += scan.stamp - before_->stamp;
  result_.false_jumps += has_jumped;
  result_.left_tracking +=
      before_->answer.status == Status::kTracking && scan.answer.status != Status::kTracking;
}

void ExperimentJudge::noteWrong(const JudgedScan& scan) {
  const bool is_silent =
      scan.answer.status == Status::kTracking && isWrong(scan.answer.T_map_base, *scan.T_map_base);
  result_.silently_wrong += is_silent;
  silent_.note(is_silent, before_ ? before_->stamp : scan.stamp);
  if (is_silent) {
    result_.silently_wrong_s = std::max(result_.silently_wrong_s, scan.stamp - silent_.since);
  }
}

void ExperimentJudge::noteModes(const JudgedScan& scan) {
  const auto& modes = scan.answer.modes;
  if (scan.answer.status == Status::kAmbiguous) {
    ++ambiguous_;
    if (!modes.empty()) first_masses_ += modes[0].mass;
    if (modes.size() > 1) second_masses_ += modes[1].mass;
  }
  if (!half_turn_ || !scan.T_map_base) return;
  // The modes are as of the last update; since then the robot has moved within the gate.
  result_.has_both_at_end =
      hasMode(modes, *scan.T_map_base) && hasMode(modes, turnedHalf(*half_turn_, *scan.T_map_base));
  both_ += result_.has_both_at_end;
  ++judged_modes_;
}

void ExperimentJudge::noteProbes(const JudgedScan& scan) {
  while (!probes_.empty() && scan.stamp >= probes_.front()) {
    result_.probe_errors_m.push_back(distance(scan.answer.T_map_base, *scan.T_map_base));
    probes_.erase(probes_.begin());
  }
}

ExperimentResult ExperimentJudge::finish() {
  const auto share = [](double sum, int count) { return count > 0 ? sum / count : 0.0; };
  result_.first_mass = share(first_masses_, ambiguous_);
  result_.second_mass = share(second_masses_, ambiguous_);
  if (half_turn_) result_.both_share = share(both_, judged_modes_);
  result_.rms_m = rootMeanSquare(errors_m_);
  result_.rms_deg = kDegrees * rootMeanSquare(errors_rad_);
  result_.max_m = largest(errors_m_);
  result_.accuracy = accuracy_.finish();
  result_.particles_mean = mean(counts_);
  result_.particles_max = static_cast<int>(largest(counts_));
  result_.update_ms_median = quantile(times_, 0.5);
  result_.update_ms_max = largest(times_);
  return result_;
}

}  // namespace adaptive_localization
