// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/carmen_log.hpp"

#include <algorithm>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "carmen_line.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kMostWarnings = 20;

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// Pulls a stamp that is later than those after it back to them: a message that waited in a queue.
/// Returns how many.
int repairStamps(std::vector<LogScan>& scans) {
  int repaired = 0;
  for (std::size_t i = scans.size(); i-- > 1;) {
    if (scans[i - 1].scan.stamp <= scans[i].scan.stamp) continue;
    scans[i - 1].scan.stamp = scans[i].scan.stamp;
    ++repaired;
  }
  return repaired;
}

void warnOfLine(int number, const std::string& problem, Log& log) {
  ++log.skipped;
  if (log.warnings.size() == kMostWarnings) log.warnings.push_back("more broken lines follow");
  if (log.warnings.size() > kMostWarnings) return;
  log.warnings.push_back("line " + std::to_string(number) + ": " + problem + "; skipped");
}

}  // namespace

Log readCarmenLog(std::istream& input, const LogRequest& request) {
  Log log;
  CarmenParser parser;
  std::string line;
  for (int number = 1; std::getline(input, line); ++number) {
    try {
      if (auto scan = parser.parse(line)) log.scans.push_back(std::move(*scan));
    } catch (const std::invalid_argument& error) {
      warnOfLine(number, error.what(), log);
    }
  }
  if (log.skipped > 0) {
    log.warnings.push_back("broken lines skipped in all: " + std::to_string(log.skipped));
  }
  if (!log.scans.empty() && !parser.knowsMount()) {
    log.warnings.push_back(
        "no 'PARAM robot_frontlaser_offset'; the laser is taken to sit at the robot's centre");
  }
  if (const int repaired = repairStamps(log.scans); repaired > 0) {
    log.warnings.push_back(
        "scans with stamps later than those of the scans after them, pulled back: " +
        std::to_string(repaired));
  }
  log.scans.erase(
      std::remove_if(log.scans.begin(), log.scans.end(),
                     [&](const LogScan& scan) { return !isWanted(scan.scan.stamp, request); }),
      log.scans.end());
  return log;
}

Log readCarmenLog(const LogRequest& request) {
  namespace io = boost::iostreams;
  std::ifstream file(request.file, std::ios::binary);
  if (!file) throw std::invalid_argument("log '" + request.file + "': cannot be opened");
  if (!request.truth_topic.empty()) {
    throw std::invalid_argument("log '" + request.file +
                                "': a CARMEN log has no topics; give the reference with --truth");
  }
  io::filtering_istream input;
  if (endsWith(request.file, ".gz")) input.push(io::gzip_decompressor());
  if (endsWith(request.file, ".bz2")) input.push(io::bzip2_decompressor());
  input.push(file);
  try {
    input.exceptions(std::ios::badbit);
    return readCarmenLog(input, request);
  } catch (const std::ios_base::failure& error) {
    throw std::invalid_argument("log '" + request.file + "': cannot be unpacked: " + error.what());
  }
}

}  // namespace adaptive_localization
