// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "eval/log.hpp"

namespace adaptive_localization {

/// Reads a CARMEN log line by line. Scans are FLASER or ROBOTLASER1 lines, whichever comes first.
class CarmenParser {
 public:
  /// The scan of a front laser line; nothing for any other line.
  /// Throws std::invalid_argument saying what is wrong with a broken line.
  std::optional<LogScan> parse(const std::string& line);

  /// Whether the log has said where the laser sits.
  bool knowsMount() const { return knows_mount_; }

 private:
  Pose2 T_base_laser_;
  double range_max_{80.0};  // m; a SICK LMS reports 81 m and more for "nothing seen"
  bool knows_mount_{false};
  std::string scan_kind_;  // of the first scan; a log with both kinds holds each scan twice

  void readParameter(const std::string& name, const std::string& line);
};

}  // namespace adaptive_localization
