// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace adaptive_localization {
namespace {

/// What is no file, as /dev/stdout, is nobody's; nor can files be locked in every file system.
bool isTaken(int descriptor) {
  struct stat status {};
  const bool is_file = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  return is_file && flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

std::tuple<std::string, std::string, std::string, int> keyOf(const RunId& id) {
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

}  // namespace

/// Keeps a file, which it makes if there is none, for one program alone, among those that lock it,
/// until it is destroyed or the program ends, however it does.
class FileLock {
 public:
  explicit FileLock(const std::string& file)
      : descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)) {
    const std::string what = "results '" + file + "': ";
    if (descriptor_ < 0) throw std::invalid_argument(what + "cannot be written");
    if (!isTaken(descriptor_)) return;
    close(descriptor_);
    throw std::invalid_argument(what + "is being written by another program");
  }
  ~FileLock() { close(descriptor_); }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

ExperimentFile::ExperimentFile(const std::string& file)
    : file_(file), lock_(std::make_shared<const FileLock>(file)) {
  if (std::filesystem::is_regular_file(file)) {
    const Lines lines = readLines(file);
    for (std::size_t i = 0; i < lines.whole.size(); ++i) {
      if (!lines.whole[i].empty()) take(lines.whole[i], i + 1);
    }
    if (!lines.rest.empty()) {
      std::filesystem::resize_file(file, std::filesystem::file_size(file) - lines.rest.size());
    }
  }
  output_.open(file, std::ios::binary | std::ios::app);
  if (!output_) throw std::invalid_argument("results '" + file + "': cannot be written");
}

std::vector<PlannedRun> ExperimentFile::missing(const std::vector<PlannedRun>& runs) const {
  std::vector<PlannedRun> left;
  for (const auto& run : runs) {
    const RunId id = run.id();
    const auto found = settings_.find(keyOf(id));
    if (found == settings_.end()) {
      left.push_back(run);
    } else if (found->second != id.settings) {
      throw std::invalid_argument("results '" + file_ + "': hold a run of " + id.name() +
                                  " that was made with other settings, expected a file of the "
                                  "same experiment, or a new one");
    }
  }
  return left;
}

void ExperimentFile::add(const ExperimentResult& result) {
  output_ << toLine(result) + "\n" << std::flush;
  if (!output_) throw std::runtime_error("results '" + file_ + "': cannot be written");
  settings_[keyOf(result.id)] = result.id.settings;
}

void ExperimentFile::take(const std::string& line, std::size_t number) {
  try {
    const RunId id = idOf(line);
    settings_[keyOf(id)] = id.settings;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("results '" + file_ + "', line " + std::to_string(number) + ": " +
                                error.what());
  }
}

}  // namespace adaptive_localization
