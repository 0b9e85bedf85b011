// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace adaptive_localization {

/// A run [begin, end) of a loop; the index counts the runs of that loop.
struct Chunk {
  std::size_t index;
  std::size_t begin;
  std::size_t end;
};

/// Number of threads a parallelFor may use, for the whole process; 1 runs every loop in the caller.
/// May be called at any time: loops that run keep the number that they began with.
void setThreads(int count);

/// Calls body for every chunk of [0, count), each chunk_size long but the last. The cut does not
/// depend on the number of threads: what a chunk computes from its own data and from
/// Rng::split(chunk.index) is the same for any number of them. Runs on OpenCV's pool.
void parallelFor(std::size_t count, std::size_t chunk_size,
                 const std::function<void(const Chunk&)>& body);

}  // namespace adaptive_localization
