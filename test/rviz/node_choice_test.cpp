// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/node_choice.hpp"

#include <gmock/gmock.h>

namespace adaptive_localization {

TEST(NodeChoice, TakesTheFirstThatThereIs) {
  NodeChoice choice;
  choice.update({}, 0.0);
  EXPECT_EQ(choice.current(), "");
  EXPECT_FALSE(choice.isThere());
  choice.update({"/a", "/b"}, 1.0);
  EXPECT_EQ(choice.current(), "/a");
  EXPECT_TRUE(choice.isThere());
}

TEST(NodeChoice, WaitsForANodeThatStartsAgain) {
  NodeChoice choice;
  choice.update({"/b"}, 0.0);
  choice.update({"/a", "/b"}, 1.0);
  EXPECT_EQ(choice.current(), "/b") << "the one that was shown";
  choice.update({"/a"}, 5.0);
  EXPECT_EQ(choice.current(), "/b");
  EXPECT_FALSE(choice.isThere());
  choice.update({"/a", "/b"}, 6.0);
  EXPECT_EQ(choice.current(), "/b");
  EXPECT_TRUE(choice.isThere());
}

TEST(NodeChoice, TakesAnotherWhenItIsGoneForGood) {
  NodeChoice choice;
  choice.update({"/b"}, 0.0);
  choice.update({"/a"}, 9.0);
  EXPECT_EQ(choice.current(), "/b");
  choice.update({"/a"}, 11.0);
  EXPECT_EQ(choice.current(), "/a");
  EXPECT_TRUE(choice.isThere());
}

TEST(NodeChoice, KeepsWhatSomebodyChose) {
  NodeChoice choice;
  choice.update({"/a"}, 0.0);
  choice.choose("/c");
  EXPECT_EQ(choice.chosen(), "/c");
  EXPECT_EQ(choice.current(), "/c");
  EXPECT_FALSE(choice.isThere());
  choice.update({"/a"}, 1000.0);
  EXPECT_EQ(choice.current(), "/c");
  choice.update({"/a", "/c"}, 1001.0);
  EXPECT_TRUE(choice.isThere());
  choice.choose("");
  choice.update({"/a"}, 2000.0);
  EXPECT_EQ(choice.current(), "/a") << "nobody's choice any more";
}

}  // namespace adaptive_localization
