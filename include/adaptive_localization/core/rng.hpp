// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/random/normal_distribution.hpp>
#include <cstdint>
#include <limits>

namespace adaptive_localization {

/// Seeded, splittable source of randomness: xoshiro256++ (Blackman and Vigna 2018), its state
/// filled by splitmix64. Same seed, same numbers on every machine. Usable as a
/// UniformRandomBitGenerator.
///
/// Parallel loops call split(chunk) once per chunk of fixed size, so results do not depend on the
/// number of threads.
class Rng {
 public:
  using result_type = std::uint64_t;

  explicit Rng(std::uint64_t seed) : seed_(seed) {
    for (auto& word : state_) word = splitMix(seed);
  }

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  result_type operator()() {
    const std::uint64_t result = rotateLeft(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = rotateLeft(state_[3], 45);
    return result;
  }

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>((*this)() >> 11) * 0x1.0p-53; }

  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform integer in [0, count); count must be positive.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }

  /// Standard normal (Boost's ziggurat, whose numbers do not depend on the platform).
  double normal() { return boost::random::normal_distribution<double>()(*this); }
  double normal(double mean, double standard_deviation) {
    return mean + standard_deviation * normal();
  }

  /// An independent generator for a stream number; does not change this one.
  Rng split(std::uint64_t stream) const {
    std::uint64_t mixed = state_[0] ^ rotateLeft(state_[2], 17) ^ (stream * 0xd1342543de82ef95ULL);
    return Rng(splitMix(mixed) ^ stream);
  }

  /// A generator for the next parallel loop; advances this one.
  Rng fork() { return Rng((*this)()); }

  std::uint64_t seed() const { return seed_; }

 private:
  static std::uint64_t rotateLeft(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

  static std::uint64_t splitMix(std::uint64_t& state) {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  std::uint64_t seed_;
  std::uint64_t state_[4];
};

}  // namespace adaptive_localization
