// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel.hpp"

#include <atomic>
#include <opencv2/core.hpp>

namespace adaptive_localization {
namespace {

std::atomic<int> threads{1};

}  // namespace

void setThreads(int count) {
  threads = count;
}

/// The pool keeps its size: cv::setNumThreads would make it anew, under the feet of a loop that
/// another thread is in. A loop cut into as many stripes as threads are allowed uses no more.
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
  const int stripes = threads;
  if (chunks < 2 || stripes < 2) {
    run(all);
  } else {
    cv::parallel_for_(all, run, stripes);
  }
}

}  // namespace adaptive_localization
