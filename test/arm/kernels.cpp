// SPDX-License-Identifier: BSD-3-Clause
// Built for 64-bit ARM and run by an emulator, where there is no library of tests: whether the
// kernels in NEON give the same bits as the portable ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

#include "adaptive_localization/core/rng.hpp"
#include "observation/field_kernel.hpp"
#include "ser/range_kernel.hpp"
#include "ser/scan_energy.hpp"

namespace adaptive_localization {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kHuge = std::numeric_limits<float>::infinity();

struct Poses {
  std::vector<float> u, v, cos, sin;

  void add(float at_u, float at_v, double turn) {
    u.push_back(at_u);
    v.push_back(at_v);
    cos.push_back(static_cast<float>(std::cos(turn)));
    sin.push_back(static_cast<float>(std::sin(turn)));
  }
  std::size_t size() const { return u.size(); }
  PoseColumns columns() const { return {u.data(), v.data(), cos.data(), sin.data()}; }
};

/// Poses inside the table, outside and nowhere, as many as do not fill whole registers.
Poses drawPoses(Rng& rng, double columns, double rows) {
  Poses poses;
  for (int i = 0; i < 1001; ++i) {
    poses.add(static_cast<float>(rng.uniform(-0.5 * columns, 1.5 * columns)),
              static_cast<float>(rng.uniform(-0.5 * rows, 1.5 * rows)), rng.uniform(-4.0, 4.0));
  }
  poses.add(kNaN, 1.0F, 0.0);
  poses.add(1.0F, kHuge, 0.0);
  poses.add(-kHuge, kNaN, 1.0);
  return poses;
}

bool isSameScore(Rng& rng) {
  constexpr int kStride = 3 * SparseGrid::kTileColumns, kRows = 2 * SparseGrid::kTileRows;
  std::vector<std::uint16_t> values(kStride * kRows + 1);
  for (auto& value : values) value = static_cast<std::uint16_t>(rng.below(65536));
  const FieldView field{values.data(), kStride, kStride - 0.01F, kRows - 0.01F};
  const Poses poses = drawPoses(rng, kStride, kRows);
  std::vector<float> x, y;
  for (int i = 0; i < 61; ++i) {
    x.push_back(static_cast<float>(rng.uniform(-80.0, 80.0)));
    y.push_back(static_cast<float>(rng.uniform(-80.0, 80.0)));
  }
  std::vector<std::int32_t> portable(poses.size()), fastest(poses.size());
  for (const std::size_t begin : {0U, 3U}) {
    const int hits = static_cast<int>(x.size());
    sumPortable(field, poses.columns(), begin, poses.size(), x.data(), y.data(), hits,
                portable.data());
    fastestSum()(field, poses.columns(), begin, poses.size(), x.data(), y.data(), hits,
                 fastest.data());
    if (portable != fastest) return false;
  }
  return true;
}

bool isSameDistance(Rng& rng) {
  using Row = std::array<std::uint8_t, kRangeStride>;
  std::array<Row, 4> rows{};  // two of intervals, from low to high
  for (std::size_t i = 0; i < 2 * kRangeStride; ++i) {
    const auto [low, high] = std::minmax({rng.below(256), rng.below(256)});
    const std::size_t interval = 2 * (i / kRangeStride), at = i % kRangeStride;
    rows[interval][at] = static_cast<std::uint8_t>(low);
    rows[interval + 1][at] = static_cast<std::uint8_t>(high);
  }
  constexpr std::array<int, RangeTarget::kParts> kParts{128, 0, 160, 64, 32, 96};
  const int count = 2 * static_cast<int>(rng.below(4));
  const RangeTarget target{rows[2].data(), rows[3].data(), kParts, count};
  const int truncation = 1 + static_cast<int>(rng.below(255));
  const int most = static_cast<int>(rng.below(20000));
  const auto sumBy = [&](RangeKernel kernel) {
    return kernel(rows[0].data(), rows[1].data(), target, truncation, most);
  };
  return sumBy(fastestSumOfDistances()) == sumBy(sumOfDistancesPortable);
}

int run() {
  if (fastestSum() == sumPortable || fastestSumOfDistances() == sumOfDistancesPortable) {
    std::puts("kernels: no kernels in NEON were built");
    return 1;
  }
  Rng rng(1);
  for (int i = 0; i < 20; ++i) {
    if (!isSameScore(rng)) return std::puts("field_kernel: sums differ"), 1;
  }
  for (int i = 0; i < 20000; ++i) {
    if (!isSameDistance(rng)) return std::puts("range_kernel: sums differ"), 1;
  }
  std::puts("the same bits in NEON");
  return 0;
}

}  // namespace
}  // namespace adaptive_localization

int main() {
  return adaptive_localization::run();
}
