// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/parallel.hpp"

#include <atomic>
#include <opencv2/core.hpp>

namespace adaptive_localization {

/// Localizers that run beside each other ask for the same number again and again, and OpenCV's pool
/// must not be made anew under one that uses it.
void setThreads(int count) {
  static std::atomic<int> current{-1};
  if (current.exchange(count) != count) cv::setNumThreads(count);
}

void parallelFor(std::size_t count, std::size_t chunk_size,
                 const std::function<void(const Chunk&)>& body) {
  const std::size_t chunks = (count + chunk_size - 1) / chunk_size;
  const auto run = [&](const cv::Range& range) {
    for (int c = range.start; c < range.end; ++c) {
      const auto index = static_cast<std::size_t>(c);
      body({index, index * chunk_size, std::min(count, (index + 1) * chunk_size)});
    }
  };
  const cv::Range all(0, static_cast<int>(chunks));
  if (chunks < 2 || cv::getNumThreads() < 2) {
    run(all);
  } else {
    cv::parallel_for_(all, run);
  }
}

}  // namespace adaptive_localization
