// SPDX-License-Identifier: BSD-3-Clause
// What the node tells of itself.
#include "localization_node.hpp"

namespace adaptive_localization {

EstimatePublisher::Figures LocalizationNode::figures(const ros::Time& stamp) const {
  EstimatePublisher::Figures figures;
  figures.stamp = stamp;
  if (const Match* match = scans_.hasTopics() ? localizer_->match() : nullptr) {
    figures.match = match->fault;
    figures.match_inliers = match->inlier_ratio;
  }
  figures.ms_per_update = ms_per_update_;
  figures.particles = localizer_->hypotheses().size();
  figures.scans = scans_.counts();
  figures.senses = senses();
  return figures;
}

NodeHealth LocalizationNode::health() const {
  NodeHealth health;
  health.scans = scans_.counts();
  health.senses = senses();
  const bool wants_pose =
      localizer_ ? answer_ && answer_->status == Status::kUninitialised : !prior_.has_value();
  const auto lack = [&](const std::string& what) {
    if (!what.empty()) health.missing += (health.missing.empty() ? "" : "; ") + what;
  };
  health.rivals = tf_input_.rivals();
  lack(scans_.missing());
  if (!localizer_) lack("a map on " + maps_.name());
  health.is_as_told = wants_pose && health.missing.empty();
  if (wants_pose) lack("an initial pose");
  health.latency = publisher_.latency();
  if (answer_ && answer_->status != Status::kUninitialised) {
    health.covariance = answer_->covariance;
  }
  const bool is_matched = localizer_ && scans_.hasTopics();
  if (const Match* match = is_matched ? localizer_->match() : nullptr) health.match = match->fault;
  return health;
}

/// What is heard by senses beside the laser, and what becomes of it.
std::vector<SenseStatus> LocalizationNode::senses() const {
  std::vector<SenseStatus> all;
  for (const SenseHealth& sense : headings_.health()) {
    const bool is_heard = sense.missing.empty();
    const std::string use = !localizer_               ? "no map yet"
                            : sense.name == "compass" ? localizer_->compass().state()
                                                      : localizer_->gyroscope().state();
    all.push_back({sense, is_heard ? use : sense.missing, is_heard && use != "disturbed"});
  }
  for (const auto& sense : {landmarks_.health(), sonars_.health()}) {
    if (!sense) continue;
    const bool is_heard = sense->missing.empty();
    all.push_back({*sense, is_heard ? "used" : sense->missing, is_heard});
  }
  return all;
}

}  // namespace adaptive_localization
