// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/core/rng.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace adaptive_localization {
namespace {

struct Moments {
  double mean{0.0}, variance{0.0}, kurtosis{0.0};
};

template <class Draw>
Moments momentsOf(int count, const Draw& draw) {
  double m1 = 0.0, m2 = 0.0, m3 = 0.0, m4 = 0.0;
  for (int i = 0; i < count; ++i) {
    const double value = draw();
    m1 += value / count;
    m2 += value * value / count;
    m3 += value * value * value / count;
    m4 += value * value * value * value / count;
  }
  const double variance = m2 - m1 * m1;
  const double fourth = m4 - 4.0 * m1 * m3 + 6.0 * m1 * m1 * m2 - 3.0 * m1 * m1 * m1 * m1;
  return {m1, variance, fourth / (variance * variance)};
}

// xoshiro256++ seeded by splitmix64, computed by an independent implementation in Python
TEST(Rng, GivesTheNumbersOfXoshiro256PlusPlus) {
  Rng rng(1);
  EXPECT_EQ(rng(), 14971601782005023387ULL);
  EXPECT_EQ(rng(), 13781649495232077965ULL);
  EXPECT_EQ(rng(), 1847458086238483744ULL);
}

TEST(Rng, SameSeedSameNumbersOtherSeedOthers) {
  Rng a(7), b(7), c(8);
  int equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto x = a();
    ASSERT_EQ(x, b());
    equal += x == c() ? 1 : 0;
  }
  EXPECT_EQ(equal, 0);
}

TEST(Rng, UniformHasItsMomentsAndStaysInside) {
  Rng rng(3);
  const Moments m = momentsOf(200000, [&] {
    const double u = rng.uniform();
    EXPECT_GE(u, 0.0);
    EXPECT_LT(u, 1.0);
    return u;
  });
  EXPECT_NEAR(m.mean, 0.5, 0.003);
  EXPECT_NEAR(m.variance, 1.0 / 12.0, 0.001);
  EXPECT_NEAR(m.kurtosis, 1.8, 0.02);
}

TEST(Rng, NormalHasItsMoments) {
  Rng rng(4);
  const Moments m = momentsOf(200000, [&] { return rng.normal(2.0, 3.0); });
  EXPECT_NEAR(m.mean, 2.0, 0.03);
  EXPECT_NEAR(m.variance, 9.0, 0.15);
  EXPECT_NEAR(m.kurtosis, 3.0, 0.06);
}

TEST(Rng, BelowIsUniformOverItsNumbers) {
  Rng rng(5);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(rng.below(7));
  double chi2 = 0.0;
  for (const int count : counts) chi2 += (count - 10000.0) * (count - 10000.0) / 10000.0;
  EXPECT_LT(chi2, 22.5);  // 99.9 % for 6 degrees of freedom
}

TEST(Rng, SplitDoesNotChangeItsSourceAndIsReproducible) {
  const Rng rng(6);
  Rng touched = rng;
  Rng a = touched.split(3);
  Rng b = rng.split(3);
  EXPECT_EQ(a(), b());
  Rng untouched = rng;
  EXPECT_EQ(touched(), untouched());
}

TEST(Rng, StreamsAreDistinctAndUncorrelated) {
  const Rng rng(9);
  std::set<std::uint64_t> firsts;
  for (std::uint64_t stream = 0; stream < 5000; ++stream) firsts.insert(rng.split(stream)());
  EXPECT_EQ(firsts.size(), 5000u);

  Rng a = rng.split(0), b = rng.split(1);
  double correlation = 0.0;
  for (int i = 0; i < 100000; ++i) correlation += 12.0 * (a.uniform() - 0.5) * (b.uniform() - 0.5);
  EXPECT_NEAR(correlation / 100000, 0.0, 0.013);  // four standard deviations
}

TEST(Rng, FirstNumbersOfStreamsAreUniform) {
  const Rng rng(10);
  std::uint64_t stream = 0;
  const Moments m = momentsOf(50000, [&] { return rng.split(stream++).uniform(); });
  EXPECT_NEAR(m.mean, 0.5, 0.006);
  EXPECT_NEAR(m.variance, 1.0 / 12.0, 0.002);
}

TEST(Rng, ForkAdvancesItsSource) {
  Rng rng(11);
  Rng first = rng.fork();
  Rng second = rng.fork();
  EXPECT_NE(first(), second());
}

}  // namespace
}  // namespace adaptive_localization
