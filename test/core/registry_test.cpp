// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/core/registry.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <memory>

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Number {
  std::string name;
  std::function<std::unique_ptr<int>(int)> make;
};

Registry<Number> numbers() {
  Registry<Number> registry("number");
  registry.add({"twice", [](int value) { return std::make_unique<int>(2 * value); }});
  registry.add({"none", [](int) { return nullptr; }});
  registry.add({"same", [](int value) { return std::make_unique<int>(value); }});
  return registry;
}

template <class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Registry, MakesWhatIsNamed) {
  const Registry<Number> registry = numbers();
  EXPECT_EQ(registry.key(), "number");
  EXPECT_THAT(registry.names(), ElementsAre("none", "same", "twice"));
  EXPECT_EQ(registry.find("same").name, "same");
  EXPECT_EQ(*registry.make("same", 3), 3);
  EXPECT_EQ(*registry.make("twice", 3), 6);
}

TEST(Registry, NamesItsOptionAndAllThatItKnowsWhenANameIsUnknown) {
  const std::string expected = "option 'number': got 'thrice', expected one of none, same, twice";
  EXPECT_EQ(complaint([] { numbers().find("thrice"); }), expected);
  EXPECT_EQ(complaint([] { numbers().make("thrice", 1); }), expected);
}

TEST(Registry, RefusesWhatMakesNothing) {
  EXPECT_EQ(complaint([] { numbers().make("none", 1); }), "option 'number': 'none' makes nothing");
}

TEST(Registry, TakesNoNameTwiceAndNothingWithoutNameOrFactory) {
  Registry<Number> registry = numbers();
  const auto make = registry.find("same").make;
  EXPECT_THAT(complaint([&] { registry.add({"same", make}); }), HasSubstr("number 'same'"));
  EXPECT_THAT(complaint([&] { registry.add({"", make}); }), HasSubstr("number ''"));
  EXPECT_THAT(complaint([&] { registry.add({"empty", nullptr}); }), HasSubstr("number 'empty'"));
  EXPECT_THAT(registry.names(), ElementsAre("none", "same", "twice"));
}

}  // namespace
}  // namespace adaptive_localization
