// SPDX-License-Identifier: BSD-3-Clause
#include "core/pose_bins.hpp"

#include <algorithm>
#include <cmath>

#include "core/parts.hpp"

namespace adaptive_localization {
namespace {

/// A pose that is far off every map, or none at all, still has a bin with neighbours.
std::int32_t indexOf(double coordinate) {
  const double clamped = coordinate > -1e9 ? (coordinate < 1e9 ? coordinate : 1e9) : -1e9;
  const auto truncated = static_cast<std::int32_t>(clamped);
  return truncated - (clamped < truncated ? 1 : 0);
}

}  // namespace

PoseBins::PoseBins(double side, double angle)
    : side_(side),
      headings_(std::max(1, static_cast<int>(std::lround(2.0 * kPi / angle)))),
      slots_(64, kNone) {}

PoseBin PoseBins::binOf(const Pose2& pose) const {
  const double turn = pose.theta / (2.0 * kPi);
  const std::int32_t heading = indexOf((turn - indexOf(turn)) * headings_);
  return {indexOf(pose.x / side_), indexOf(pose.y / side_), std::clamp(heading, 0, headings_ - 1)};
}

std::size_t PoseBins::slotOf(const PoseBin& bin) const {
  std::uint64_t hash = static_cast<std::uint32_t>(bin.x) * 0x9e3779b97f4a7c15ULL;
  hash = (hash ^ static_cast<std::uint32_t>(bin.y)) * 0xbf58476d1ce4e5b9ULL;
  hash = (hash ^ static_cast<std::uint32_t>(bin.theta)) * 0x94d049bb133111ebULL;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = static_cast<std::size_t>(hash >> 32) & mask;
  while (slots_[slot] != kNone) {
    const PoseBin& other = bins_[static_cast<std::size_t>(slots_[slot])];
    if (other.x == bin.x && other.y == bin.y && other.theta == bin.theta) break;
    slot = (slot + 1) & mask;
  }
  return slot;
}

int PoseBins::addBin(const PoseBin& bin) {
  const std::size_t slot = slotOf(bin);
  if (slots_[slot] != kNone) return slots_[slot];
  const int number = count();
  slots_[slot] = number;
  bins_.push_back(bin);
  if (2 * bins_.size() > slots_.size()) grow();
  return number;
}

/// Parts of a long cloud are put into bins of their own, side by side, which are then numbered in
/// the order of the parts: as if the particles had come one by one.
std::vector<int> PoseBins::addAll(const Particles& particles) {
  std::vector<int> numbers(static_cast<std::size_t>(particles.size()));
  if (particles.size() <= kShort) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = add(particles.pose(static_cast<Eigen::Index>(i)));
    }
    return numbers;
  }
  std::vector<PoseBins> own((numbers.size() + kPart - 1) / kPart,
                            PoseBins(side_, 2.0 * kPi / headings_));
  forEachPart(particles.size(), [&](Eigen::Index first, Eigen::Index size) {
    PoseBins& bins = own[static_cast<std::size_t>(first / kPart)];
    for (Eigen::Index i = first; i < first + size; ++i) {
      numbers[static_cast<std::size_t>(i)] = bins.add(particles.pose(i));
    }
  });
  std::vector<std::vector<int>> here(own.size());  // for each part, its numbers' here
  for (std::size_t part = 0; part < own.size(); ++part) {
    for (const PoseBin& bin : own[part].bins_) here[part].push_back(addBin(bin));
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = here[i / kPart][static_cast<std::size_t>(numbers[i])];
  }
  return numbers;
}

int PoseBins::find(PoseBin bin) const {
  bin.theta = (bin.theta + headings_) % headings_;
  return slots_[slotOf(bin)];
}

void PoseBins::grow() {
  slots_.assign(2 * slots_.size(), kNone);
  for (int number = 0; number < count(); ++number) slots_[slotOf(bin(number))] = number;
}

}  // namespace adaptive_localization
