// SPDX-License-Identifier: BSD-3-Clause
#include "eval/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

namespace adaptive_localization {
namespace {

constexpr std::chrono::milliseconds kShortWork(2000);
constexpr std::chrono::milliseconds kPeriod(100);
constexpr std::size_t kWidth = 40;

}  // namespace

ProgressBar::ProgressBar(std::size_t total, bool is_wanted, std::string unit)
    : total_(std::max<std::size_t>(total, 1)),
      is_wanted_(is_wanted && isatty(STDERR_FILENO)),
      unit_(std::move(unit)),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

ProgressBar::~ProgressBar() {
  if (is_drawn_) std::fprintf(stderr, "\r\033[K");
}

void ProgressBar::show(std::size_t done) {
  if (!is_wanted_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - start_ < kShortWork || now - last_ < kPeriod) return;
  last_ = now;
  is_drawn_ = true;
  const std::size_t filled = kWidth * std::min(done, total_) / total_;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const auto left = static_cast<double>(total_ - std::min(done, total_));
  std::fprintf(stderr, "\r[%s%s] %zu/%zu %s, %.0f s left ", std::string(filled, '#').c_str(),
               std::string(kWidth - filled, ' ').c_str(), done, total_, unit_.c_str(),
               elapsed * left / static_cast<double>(std::max<std::size_t>(done, 1)));
}

}  // namespace adaptive_localization
