// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "eval/experiment_plan.hpp"
#include "eval/experiment_result.hpp"

namespace adaptive_localization {

class FileLock;

/// A file of results, one JSON line per run in any order, that grows run by run and can be gone on
/// with after an interruption.
class ExperimentFile {
 public:
  /// Takes up what the file holds, without a last line that was cut off, and keeps others away.
  /// Throws std::invalid_argument naming the file when it cannot be read or written or another
  /// program is writing it.
  explicit ExperimentFile(const std::string& file);

  /// The runs that the file does not hold yet. Throws std::invalid_argument when it holds one of
  /// them made with other settings, which would make a summary of unlike things.
  std::vector<PlannedRun> missing(const std::vector<PlannedRun>& runs) const;

  /// Writes a line and sees to it that it gets to the file.
  /// Throws std::runtime_error naming the file.
  void add(const ExperimentResult& result);

  /// How many runs it holds.
  std::size_t size() const { return settings_.size(); }

 private:
  void take(const std::string& line, std::size_t number);

  std::string file_;
  std::shared_ptr<const FileLock> lock_;
  /// Of the runs that it holds, by experiment, case, core and seed.
  std::map<std::tuple<std::string, std::string, std::string, int>, std::string> settings_;
  std::ofstream output_;
};

}  // namespace adaptive_localization
