// SPDX-License-Identifier: BSD-3-Clause
#include "bag_stream.hpp"

#include <algorithm>
#include <stdexcept>

namespace adaptive_localization {

BagStream::BagStream(const std::string& file)
    : reader_([file](std::FILE* out) { sendBag(file, out); }) {}

void BagStream::sayDamaged() {
  throw std::invalid_argument("is damaged: reading it ended with '" + reader_.end() + "'");
}

BagRecord BagStream::receive() {
  BagRecord record;
  if (!adaptive_localization::receive(reader_, record)) sayDamaged();
  if (record.kind == BagRecord::kFailed) {
    throw std::invalid_argument(
        "cannot be read: " + record.text() +
        "; if it was cut off or never closed, 'rosbag reindex' saves what was recorded");
  }
  return record;
}

const std::map<std::string, std::string>& BagStream::types() {
  while (!has_contents_) {
    const BagRecord record = receive();
    const std::string text = record.text();
    has_contents_ = record.kind == BagRecord::kContents;
    if (has_contents_) break;
    topics_.emplace_back(text.c_str(), text.substr(std::min(text.size(), text.find('\0') + 1)));
    types_[topics_.back().first] = topics_.back().second;
  }
  return types_;
}

std::optional<BagMessage> BagStream::next() {
  types();
  while (!is_over_) {
    BagRecord record = receive();
    is_over_ = record.kind == BagRecord::kEnd;
    if (record.kind == BagRecord::kStopped) why_stopped_ = record.text();
    if (is_over_ || record.kind == BagRecord::kStopped) continue;
    if (record.topic >= topics_.size()) sayDamaged();
    const auto& [topic, type] = topics_[record.topic];
    return BagMessage{topic, type, record.kind == BagRecord::kFixed,
                      record.kind == BagRecord::kBroken, std::move(record.bytes)};
  }
  return std::nullopt;
}

}  // namespace adaptive_localization
