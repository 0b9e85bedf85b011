// SPDX-License-Identifier: BSD-3-Clause
#include "eval/outputs.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <stdexcept>

#include "support/temp_folder.hpp"

namespace adaptive_localization {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Outputs, NoInputIsWrittenToByWhateverName) {
  TempFolder folder;
  const std::string log = folder.write("run.bag", "recorded");
  const std::string link = folder.file("link.bag");
  std::filesystem::create_symlink(log, link);
  std::filesystem::create_hard_link(log, folder.file("other.bag"));
  for (const std::string& name :
       {log, link, folder.file("other.bag"),
        folder.file("../") +
            std::filesystem::path(folder.file("")).parent_path().filename().string() +
            "/run.bag"}) {
    EXPECT_THAT(
        [&] {
          checkOutputs({"", name}, {folder.file("map.yaml"), log});
        },
        ThrowsMessage<std::invalid_argument>(
            AllOf(HasSubstr("output '" + name + "'"), HasSubstr("input '" + log + "'"))))
        << name;
  }
}

TEST(Outputs, OthersAreFree) {
  TempFolder folder;
  const std::string log = folder.write("run.bag", "recorded");
  const std::string old = folder.write("old.json", "{}");
  EXPECT_NO_THROW(checkOutputs({old, folder.file("new.json"), ""}, {log, "", "missing"}));
  EXPECT_NO_THROW(checkOutputs({"/dev/null"}, {"/dev/null"}));
}

}  // namespace
}  // namespace adaptive_localization
