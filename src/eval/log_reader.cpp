// SPDX-License-Identifier: BSD-3-Clause
#include "eval/log_reader.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "eval/carmen_log.hpp"
#ifdef ADAPTIVE_LOCALIZATION_WITH_ROSBAG
#include "eval/bag_log.hpp"
#endif

namespace adaptive_localization {
namespace {

bool isBag(const std::string& file) {
  const std::string ending = ".bag";
  if (file.size() >= ending.size() &&
      file.compare(file.size() - ending.size(), ending.size(), ending) == 0) {
    return true;
  }
  std::ifstream input(file);
  std::string first_line;
  return std::getline(input, first_line) && first_line.compare(0, 8, "#ROSBAG ") == 0;
}

Log readBag(const LogRequest& request) {
#ifdef ADAPTIVE_LOCALIZATION_WITH_ROSBAG
  return readBagLog(request);
#else
  throw std::invalid_argument("bag '" + request.file +
                              "': this program was built without rosbag; only CARMEN logs work");
#endif
}

std::string describeRange(const LogRequest& request) {
  if (std::isinf(request.begin) && std::isinf(request.end)) return "";
  std::ostringstream text;
  text.precision(16);
  text << " between the stamps " << request.begin << " and " << request.end;
  return text.str();
}

}  // namespace

Log readLog(const LogRequest& request) {
  if (!std::ifstream(request.file)) {
    throw std::invalid_argument("log '" + request.file + "': cannot be opened");
  }
  Log log = isBag(request.file) ? readBag(request) : readCarmenLog(request);
  if (log.scans.empty()) {
    std::string message =
        "log '" + request.file + "': no usable laser scan" + describeRange(request);
    for (const auto& warning : log.warnings) message += "; " + warning;
    throw std::invalid_argument(message);
  }
  return log;
}

}  // namespace adaptive_localization
