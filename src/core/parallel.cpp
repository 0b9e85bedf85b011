// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel.hpp"

#include <atomic>
#include <opencv2/core.hpp>

namespace adaptive_localization {
namespace {

std::atomic<int> threads{1};

/// The chunks of a loop. What its caller wrote before and what its stripes write is handed over by
/// an atomic, too: the thread sanitizer does not see the locks of OpenCV's pool.
class Loop : public cv::ParallelLoopBody {
 public:
  Loop(std::size_t count, std::size_t chunk_size, const std::function<void(const Chunk&)>& body)
      : count_(count), chunk_size_(chunk_size), body_(body) {
    done_.store(0, std::memory_order_release);
  }

  void operator()(const cv::Range& range) const override {
    done_.load(std::memory_order_acquire);
    for (int c = range.start; c < range.end; ++c) {
      const auto index = static_cast<std::size_t>(c);
      body_({index, index * chunk_size_, std::min(count_, (index + 1) * chunk_size_)});
    }
    done_.fetch_add(1, std::memory_order_release);
  }

  void join() const { done_.load(std::memory_order_acquire); }

 private:
  std::size_t count_, chunk_size_;
  const std::function<void(const Chunk&)>& body_;
  mutable std::atomic<int> done_;
};

}  // namespace

void setThreads(int count) {
  threads = count;
}

/// The pool keeps its size: cv::setNumThreads would make it anew, under the feet of a loop that
/// another thread is in. A loop cut into as many stripes as threads are allowed uses no more.
void parallelFor(std::size_t count, std::size_t chunk_size,
                 const std::function<void(const Chunk&)>& body) {
  const std::size_t chunks = (count + chunk_size - 1) / chunk_size;
  const Loop loop(count, chunk_size, body);
  const cv::Range all(0, static_cast<int>(chunks));
  const int stripes = threads;
  if (chunks < 2 || stripes < 2) {
    loop(all);
  } else {
    cv::parallel_for_(all, loop, stripes);
  }
  loop.join();
}

}  // namespace adaptive_localization
