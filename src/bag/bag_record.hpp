// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "child_process.hpp"

namespace adaptive_localization {

/// What the process that reads a bag sends.
struct BagRecord {
  enum Kind : std::uint32_t {
    kTopic,     // name, zero, type; they are numbered from 0
    kContents,  // those were all topics
    kFixed,     // a message of /tf_static
    kMessage,   // another one
    kBroken,    // one that is none
    kStopped,   // why the bag cannot be read on
    kFailed,    // why it cannot be read; nothing follows
    kEnd
  };
  Kind kind{kEnd};
  std::uint32_t topic{0};
  std::vector<std::uint8_t> bytes;

  std::string text() const { return {bytes.begin(), bytes.end()}; }
};

void send(std::FILE* out, BagRecord::Kind kind, std::uint32_t topic,
          const std::vector<std::uint8_t>& bytes = {});
void send(std::FILE* out, BagRecord::Kind kind, const std::string& text = {});

/// False: there are no more, or what comes is none.
bool receive(ChildProcess& sender, BagRecord& record);

/// The work of that process.
void sendBag(const std::string& file, std::FILE* out);

}  // namespace adaptive_localization
