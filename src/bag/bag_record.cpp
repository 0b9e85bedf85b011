// SPDX-License-Identifier: BSD-3-Clause
#include "bag_record.hpp"

#include <stdexcept>

namespace adaptive_localization {
namespace {

constexpr std::uint32_t kMost = 1U << 30;  // bytes

struct Header {
  std::uint32_t kind, topic, size;
};

}  // namespace

void send(std::FILE* out, BagRecord::Kind kind, std::uint32_t topic,
          const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() > kMost) throw std::length_error("a record is too long");
  const Header header{kind, topic, static_cast<std::uint32_t>(bytes.size())};
  std::fwrite(&header, sizeof(header), 1, out);
  if (!bytes.empty()) std::fwrite(bytes.data(), 1, bytes.size(), out);
}

void send(std::FILE* out, BagRecord::Kind kind, const std::string& text) {
  send(out, kind, 0, {text.begin(), text.end()});
}

bool receive(ChildProcess& sender, BagRecord& record) {
  Header header{};
  if (!sender.read(&header, sizeof(header))) return false;
  if (header.kind > BagRecord::kEnd || header.size > kMost) return false;
  record.kind = static_cast<BagRecord::Kind>(header.kind);
  record.topic = header.topic;
  record.bytes.resize(header.size);
  return sender.read(record.bytes.data(), record.bytes.size());
}

}  // namespace adaptive_localization
