// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/experiment_file.hpp"

#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "file_lock.hpp"

namespace adaptive_localization {
namespace {

using Key = std::tuple<std::string, std::string, std::string, int>;

Key keyOf(const RunId& id) {
  return {id.experiment, id.of_case, id.label, id.seed};
}

/// The whole lines of a file and, apart, what comes after the last of them.
struct Lines {
  std::vector<std::string> whole;
  std::string rest;
};

Lines readLines(const std::string& file) {
  std::ifstream input(file, std::ios::binary);
  if (!input) throw std::invalid_argument("results '" + file + "': cannot be read");
  Lines lines;
  for (std::string line; std::getline(input, line);) {
    if (input.eof()) {
      lines.rest = line;
    } else {
      lines.whole.push_back(line);
    }
  }
  return lines;
}

std::vector<ExperimentResult> parse(const Lines& lines, const std::string& file) {
  std::vector<ExperimentResult> results;
  for (std::size_t i = 0; i < lines.whole.size(); ++i) {
    if (lines.whole[i].empty()) continue;
    try {
      results.push_back(fromLine(lines.whole[i]));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("results '" + file + "', line " + std::to_string(i + 1) + ": " +
                                  error.what());
    }
  }
  return results;
}

std::shared_ptr<const FileLock> lock(const std::string& file) {
  try {
    return std::make_shared<const FileLock>(file);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("results '" + file + "': " + error.what());
  }
}

}  // namespace

std::vector<ExperimentResult> readResults(const std::string& file) {
  return parse(readLines(file), file);
}

ExperimentFile::ExperimentFile(const std::string& file) : file_(file), lock_(lock(file)) {
  if (std::filesystem::is_regular_file(file)) {
    const Lines lines = readLines(file);
    results_ = parse(lines, file);
    if (!lines.rest.empty()) {
      std::filesystem::resize_file(file, std::filesystem::file_size(file) - lines.rest.size());
    }
  }
  output_.open(file, std::ios::binary | std::ios::app);
  if (!output_) throw std::invalid_argument("results '" + file + "': cannot be written");
}

std::vector<PlannedRun> ExperimentFile::missing(const std::vector<PlannedRun>& runs) const {
  std::map<Key, std::string> settings;
  for (const auto& result : results_) settings[keyOf(result.id)] = result.id.settings;
  std::vector<PlannedRun> left;
  for (const auto& run : runs) {
    const RunId id = run.id();
    const auto found = settings.find(keyOf(id));
    if (found == settings.end()) {
      left.push_back(run);
    } else if (found->second != id.settings) {
      throw std::invalid_argument("results '" + file_ + "': hold a run of " + id.experiment + "/" +
                                  id.of_case + "/" + id.label +
                                  " that was made with other settings, expected a file of the "
                                  "same experiment, or a new one");
    }
  }
  return left;
}

void ExperimentFile::add(const ExperimentResult& result) {
  output_ << toLine(result) + "\n" << std::flush;
  if (!output_) throw std::runtime_error("results '" + file_ + "': cannot be written");
  results_.push_back(result);
}

}  // namespace adaptive_localization
