// SPDX-License-Identifier: BSD-3-Clause
#include "eval/carmen_log.hpp"

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

/// Spreads scans whose stamp is later than one after it, because the message waited in a queue,
/// evenly between their neighbours. Returns how many.
int repairStamps(std::vector<LogScan>& scans) {
  std::vector<std::size_t> good_after(scans.size());  // the next scan whose stamp can be true
  for (std::size_t i = scans.size(), good = i - 1; i-- > 0;) {
    if (scans[i].scan.stamp <= scans[good].scan.stamp) good = i;
    good_after[i] = good;
  }
  int repaired = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::size_t good = good_after[i];
    if (good == i) continue;
    const double end = scans[good].scan.stamp;
    const double start = i == 0 ? end : scans[i - 1].scan.stamp;
    scans[i].scan.stamp = start + (end - start) / static_cast<double>(good - i + 1);
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
        "scans with stamps later than those of the scans after them, spread before these: " +
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
