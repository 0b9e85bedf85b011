// SPDX-License-Identifier: BSD-3-Clause
#include "array_file.hpp"

#include <signal.h>
#include <unistd.h>
#include <xxhash.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kAlignment = 64;  // of each array in the file
constexpr std::size_t kMostArrays = 8;
constexpr const char* kPart = ".part";
constexpr std::chrono::hours kPatience{1};  // with those who write a file

struct Header {
  char name[8];
  std::uint32_t byte_order;
  std::uint32_t version;
  std::uint64_t key;
  std::uint64_t sizes[kMostArrays];  // bytes of each array; 0: none
  std::uint64_t checksum;            // of what comes before in the header, and of all arrays
};
static_assert(sizeof(Header) % 8 == 0, "no padding, which would be anything");

constexpr char kName[8] = {'S', 'E', 'R', '-', 'g', 'r', 'i', 'd'};
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint32_t kVersion = 1;

std::size_t aligned(std::size_t size) {
  return (size + kAlignment - 1) / kAlignment * kAlignment;
}

std::uint64_t checksumOf(const Header& header, const std::vector<ArrayFile::Bytes>& arrays) {
  std::uint64_t checksum = XXH64(&header, offsetof(Header, checksum), 0);
  for (const auto& array : arrays) checksum = XXH64(array.data, array.size, checksum);
  return checksum;
}

Header headerOf(const char* file) {
  Header header;
  std::memcpy(&header, file, sizeof(header));
  return header;
}

/// Beside a file; of this process, and of one call alone.
std::string partOf(const std::string& file) {
  static std::atomic<int> count{0};
  return file + "." + std::to_string(getpid()) + "." + std::to_string(count++) + kPart;
}

[[noreturn]] void reject(const std::string& file, const std::string& what) {
  throw std::runtime_error(file + ": " + what);
}

}  // namespace

ArrayFile::ArrayFile(const std::string& file, std::uint64_t key, std::size_t most_bytes)
    : file_(file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size < sizeof(Header)) reject(file, "is cut short");
  if (size > aligned(sizeof(Header)) + most_bytes + kMostArrays * kAlignment) {
    reject(file, "is longer than what it should hold");
  }
  const std::shared_ptr<char[]> memory(new char[size]);
  std::ifstream stream(file, std::ios::binary);
  stream.read(memory.get(), static_cast<std::streamsize>(size));
  if (!stream) reject(file, "cannot be read");
  memory_ = memory;
  findArrays(static_cast<std::size_t>(size));
  const Header header = headerOf(memory_.get());
  if (header.key != key) reject(file, "was made from something else");
  if (checksumOf(header, arrays_) != header.checksum) reject(file, "is damaged (wrong checksum)");
}

void ArrayFile::findArrays(std::size_t size) {
  const Header header = headerOf(memory_.get());
  if (std::memcmp(header.name, kName, sizeof(kName)) != 0) reject(file_, "is not an energy grid");
  if (header.byte_order != kByteOrder) reject(file_, "was written on another kind of machine");
  if (header.version != kVersion) {
    reject(file_, "has format version " + std::to_string(header.version) + ", expected " +
                      std::to_string(kVersion));
  }
  std::size_t end = aligned(sizeof(Header));
  for (const std::uint64_t array : header.sizes) {
    if (end > size || array > size - end) reject(file_, "is cut short");
    if (array > 0) arrays_.push_back({memory_.get() + end, static_cast<std::size_t>(array)});
    end += aligned(static_cast<std::size_t>(array));
  }
}

const ArrayFile::Bytes& ArrayFile::at(std::size_t i, std::size_t size_of_item) const {
  if (i >= arrays_.size() || arrays_[i].size % size_of_item != 0) {
    reject(file_, "does not hold what it should");
  }
  return arrays_[i];
}

void ArrayFile::write(const std::string& file, std::uint64_t key,
                      const std::vector<Bytes>& arrays) {
  Header header{};
  std::memcpy(header.name, kName, sizeof(kName));
  header.byte_order = kByteOrder;
  header.version = kVersion;
  header.key = key;
  for (std::size_t i = 0; i < arrays.size(); ++i) header.sizes[i] = arrays[i].size;
  header.checksum = checksumOf(header, arrays);

  const std::string part = partOf(file);
  errno = 0;
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  const auto put = [&](const char* data, std::size_t size) {
    constexpr char kZeros[kAlignment] = {};
    stream.write(data, static_cast<std::streamsize>(size));
    stream.write(kZeros, static_cast<std::streamsize>(aligned(size) - size));
  };
  put(reinterpret_cast<const char*>(&header), sizeof(header));
  for (const Bytes& array : arrays) put(array.data, array.size);
  stream.close();
  std::error_code error;
  if (stream) fs::rename(part, file, error);
  if (stream && !error) return;
  const std::string reason = error ? error.message() : std::strerror(errno != 0 ? errno : EIO);
  fs::remove(part, error);
  reject(file, "cannot be written: " + reason);
}

bool ArrayFile::isPart(const std::string& file) {
  return fs::path(file).extension() == kPart;
}

bool ArrayFile::isAbandoned(const std::string& part) {
  const std::string process = fs::path(part).stem().stem().extension();  // .123 of x.123.0.part
  const long id = process.empty() ? 0 : std::atol(process.c_str() + 1);
  const bool is_gone = id <= 0 || (kill(static_cast<pid_t>(id), 0) != 0 && errno == ESRCH);
  std::error_code error;
  const auto begun = fs::last_write_time(part, error);
  return is_gone || (!error && begun < fs::file_time_type::clock::now() - kPatience);
}

}  // namespace adaptive_localization
