// SPDX-License-Identifier: BSD-3-Clause
#include "node_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>

#include <cmath>
#include <ctime>
#include <utility>

#include "callbacks.hpp"
#include "status_message.hpp"

namespace adaptive_localization {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr int kComplainAfter = 5;  // s; then once in kComplainAgain
constexpr int kComplainAgain = 15;

DiagnosticStatus deviationStatus(const Eigen::Matrix3d& covariance, const NodeOptions& options) {
  const Eigen::Array3d deviation = covariance.diagonal().array().max(0.0).sqrt();
  const Eigen::Array3d limit(options.std_warn_level_x, options.std_warn_level_y,
                             options.std_warn_level_yaw);
  const bool fine = (deviation <= limit).all();
  DiagnosticStatus status =
      makeStatus("Standard deviation", fine ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                 fine ? "OK" : "Too large");
  const char* const axes[] = {"x", "y", "yaw"};
  for (int i = 0; i < 3; ++i) add(status, std::string("std_") + axes[i], print("%g", deviation[i]));
  for (int i = 0; i < 3; ++i) {
    add(status, std::string("std_warn_level_") + axes[i], print("%g", limit[i]));
  }
  return status;
}

DiagnosticStatus scanStatus(const NodeHealth& health) {
  const bool fine = health.missing.empty();
  DiagnosticStatus status =
      makeStatus("Scans", fine ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                 fine ? "OK" : "Waiting for " + health.missing);
  addCounts(status, health.scans);
  return status;
}

DiagnosticStatus transformStatus(const std::string& rivals) {
  return makeStatus("Transforms", rivals.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                    rivals.empty() ? "OK" : rivals);
}

DiagnosticStatus sensesStatus(const std::vector<SenseStatus>& senses) {
  std::string troubles;
  for (const SenseStatus& sense : senses) {
    if (sense.is_fine) continue;
    troubles += (troubles.empty() ? "" : "; ") + sense.health.name + ": " + sense.state;
  }
  const bool fine = troubles.empty();
  DiagnosticStatus status = makeStatus(
      "Senses", fine ? DiagnosticStatus::OK : DiagnosticStatus::WARN, fine ? "OK" : troubles);
  addSenses(status, senses);
  return status;
}

DiagnosticStatus matchStatus(MatchFault fault) {
  const bool fine = !isRefusal(fault);
  return makeStatus("Match", fine ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                    fine ? "OK" : "Refused: " + toText(fault));
}

/// What is wrong, in plain words; empty: nothing.
std::string lateness(const Latency::Minute& minute) {
  std::string text;
  if (minute.isLate()) {
    text = print("Late: of 100 scans one takes %.0f ms or more, and they come every %.0f ms",
                 1e3 * minute.from_arrival.p99, 1e3 * minute.period);
  }
  if (minute.isOtherClock()) {
    text += (text.empty() ? "" : "; ") +
            print("Stamps are not of this clock: of %d scans %d are from the future and %d are old",
                  minute.scans, minute.from_future, minute.from_past);
  }
  return text;
}

void addFigures(DiagnosticStatus& status, const std::string& since,
                const Latency::Figures& figures) {
  add(status, "ms from " + since + ", median", print("%.1f", 1e3 * figures.median));
  add(status, "ms from " + since + ", p99", print("%.1f", 1e3 * figures.p99));
  add(status, "ms from " + since + ", max", print("%.1f", 1e3 * figures.max));
}

DiagnosticStatus latencyStatus(const Latency::Minute& minute, double processor_share) {
  const std::string trouble = lateness(minute);
  DiagnosticStatus status =
      makeStatus("Latency", trouble.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                 !trouble.empty()    ? trouble
                 : minute.scans == 0 ? "No scan led to a transform"
                                     : "OK");
  add(status, "scans", std::to_string(minute.scans));
  if (minute.scans > 0) {
    addFigures(status, "stamp", minute.from_stamp);
    addFigures(status, "arrival", minute.from_arrival);
    add(status, "scans from the future", std::to_string(minute.from_future));
    add(status, "scans that are old", std::to_string(minute.from_past));
  }
  if (minute.scans > 1) add(status, "ms between scans", print("%.1f", 1e3 * minute.period));
  add(status, "share of a core", print("%.3f", processor_share));
  return status;
}

/// s, of all threads.
double processorTime() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

NodeDiagnostics::NodeDiagnostics(ros::NodeHandle node, const NodeOptions& options,
                                 std::function<NodeHealth()> ask)
    : options_(options),
      ask_(std::move(ask)),
      publisher_(node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1)),
      timer_(every(node, ros::WallDuration(1.0), "Diagnostics", [this] { publish(); })) {}

void NodeDiagnostics::publish() {
  const double now = ros::SteadyTime::now().toSec();
  processor_share_.add(now, processorTime());
  const NodeHealth health = ask_();
  complain(health);
  if (publisher_.getNumSubscribers() == 0) return;
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = ros::Time::now();
  if (health.covariance) message.status.push_back(deviationStatus(*health.covariance, options_));
  message.status.push_back(scanStatus(health));
  message.status.push_back(transformStatus(health.rivals));
  if (!health.senses.empty()) message.status.push_back(sensesStatus(health.senses));
  if (health.match) message.status.push_back(matchStatus(*health.match));
  message.status.push_back(latencyStatus(health.latency, processor_share_.at(now)));
  publisher_.publish(message);
}

void NodeDiagnostics::complain(const NodeHealth& health) {
  if (!health.rivals.empty() && complaints_.isDue(health.rivals)) {
    ROS_WARN("Transforms contradict each other: %s", health.rivals.c_str());
  }
  seconds_missing_ = health.missing.empty() ? 0 : seconds_missing_ + 1;
  if (seconds_missing_ % kComplainAgain != kComplainAfter) return;
  const auto level = health.is_as_told ? ros::console::levels::Info : ros::console::levels::Warn;
  ROS_LOG(level, ROSCONSOLE_DEFAULT_NAME, "Not localizing for %d s: waiting for %s",
          seconds_missing_, health.missing.c_str());
}

}  // namespace adaptive_localization
