// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/eval/experiment_plan.hpp"
#include "adaptive_localization/eval/experiment_result.hpp"

namespace adaptive_localization {

/// Reads results, one JSON line per run, in any order. A last line that was cut off is left out.
/// Throws std::invalid_argument naming file and line.
std::vector<ExperimentResult> readResults(const std::string& file);

class FileLock;

/// A file of results that grows run by run and can be gone on with after an interruption.
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

  const std::vector<ExperimentResult>& results() const { return results_; }

 private:
  std::string file_;
  std::shared_ptr<const FileLock> lock_;
  std::vector<ExperimentResult> results_;
  std::ofstream output_;
};

}  // namespace adaptive_localization
