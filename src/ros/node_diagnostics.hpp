// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "complaints.hpp"
#include "latency.hpp"
#include "match/scan_matcher.hpp"
#include "node_options.hpp"
#include "processor_share.hpp"
#include "scan_source.hpp"
#include "sense_health.hpp"

namespace adaptive_localization {

/// How the node is, for people and for /diagnostics.
struct NodeHealth {
  ScanSource::Counts scans;
  std::vector<SenseStatus> senses;            // beside the laser
  std::string missing;                        // what localizing waits for; empty: nothing
  std::string rivals;                         // nodes that publish the same frame; empty: none
  bool is_as_told{false};                     // nothing but the pose that it was told to wait for
  std::optional<Eigen::Matrix3d> covariance;  // of the last pose, if there is one
  std::optional<MatchFault> match;            // of the last scan that was matched with the map
  Latency::Minute latency;
};

/// Once a second, whether scans come or not, sends /diagnostics: amcl's "Standard deviation", and
/// "Scans" with their counters and what is missing, "Transforms" with frames that two nodes
/// publish, of filters that match scans "Match" with the reason if the last one was refused, and
/// "Latency", how late scans led to transforms in the last minute and how busy the process was.
/// What stays missing goes to the log as well.
class NodeDiagnostics {
 public:
  NodeDiagnostics(ros::NodeHandle node, const NodeOptions& options,
                  std::function<NodeHealth()> ask);

 private:
  void publish();
  void complain(const NodeHealth& health);

  const NodeOptions& options_;  // the node's, which may change
  std::function<NodeHealth()> ask_;
  int seconds_missing_{0};
  Complaints complaints_;
  ProcessorShare processor_share_;
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

}  // namespace adaptive_localization
