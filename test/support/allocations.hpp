// SPDX-License-Identifier: BSD-3-Clause
// Counts what a test's program allocates, and makes an allocation fail. It replaces malloc, so one
// file of a program includes it. Sanitizers have an allocator of their own, and only glibc has
// these names for its.
#pragma once

#include <atomic>
#include <cerrno>
#include <cstddef>

namespace allocations {

inline std::atomic<long> taken{0}, given_back{0};

/// The n-th allocation from now on gets no memory; with 0 or less none does.
inline std::atomic<long> until_failure{0};

/// Counts one, which gets memory or not.
inline bool isGranted() {
  ++taken;
  return until_failure <= 0 || --until_failure > 0;
}

}  // namespace allocations

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) noexcept {
  return allocations::isGranted() ? __libc_malloc(size) : nullptr;
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  return allocations::isGranted() ? __libc_calloc(count, size) : nullptr;
}
void* realloc(void* memory, std::size_t size) noexcept {
  const bool is_granted = memory || allocations::isGranted();
  return is_granted ? __libc_realloc(memory, size) : nullptr;
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return allocations::isGranted() ? __libc_memalign(alignment, size) : nullptr;
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  *memory = allocations::isGranted() ? __libc_memalign(alignment, size) : nullptr;
  return *memory ? 0 : ENOMEM;
}
void free(void* memory) noexcept {
  if (memory) ++allocations::given_back;
  __libc_free(memory);
}
}
