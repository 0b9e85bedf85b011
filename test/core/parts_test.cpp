// SPDX-License-Identifier: BSD-3-Clause
#include "core/parts.hpp"

#include <gtest/gtest.h>

#include <string>

namespace adaptive_localization {
namespace {

class Parts : public testing::Test {
 protected:
  void TearDown() override { setThreads(1); }
};

TEST_F(Parts, CoverEachNumberOnce) {
  for (const int threads : {1, 3}) {
    setThreads(threads);
    for (const Eigen::Index count : {Eigen::Index{0}, Eigen::Index{1}, kPart + 1, kShort,
                                     kShort + 1, 2 * kShort, 5 * kPart + 7}) {
      Eigen::ArrayXi visits = Eigen::ArrayXi::Zero(count);
      forEachPart(count, [&](Eigen::Index first, Eigen::Index size) {
        EXPECT_TRUE(count <= kShort ? size == count : size <= kPart);
        visits.segment(first, size) += 1;
      });
      EXPECT_TRUE((visits == 1).all()) << count;
    }
  }
}

TEST_F(Parts, SumToTheSameBitsForAnyNumberOfThreads) {
  const Eigen::ArrayXd numbers = Eigen::ArrayXd::LinSpaced(100003, 0.1, 7.7).sin();
  const auto sum = [&] {
    return sumOverParts<double>(numbers.size(), [&](Eigen::Index first, Eigen::Index size) {
      return numbers.segment(first, size).sum();
    });
  };
  const double alone = sum();
  setThreads(4);
  for (int n = 0; n < 20; ++n) EXPECT_EQ(sum(), alone);
  EXPECT_NEAR(alone, numbers.sum(), 1e-9);
}

TEST_F(Parts, AreAddedInTheirOrder) {
  struct Word {
    std::string letters;
    Word& operator+=(const Word& other) {
      letters += other.letters;
      return *this;
    }
  };
  setThreads(4);
  const Word word = sumOverParts<Word>(5 * kPart, [](Eigen::Index first, Eigen::Index) {
    return Word{std::string(1, static_cast<char>('a' + first / kPart))};
  });
  EXPECT_EQ(word.letters, "abcde");
}

}  // namespace
}  // namespace adaptive_localization
