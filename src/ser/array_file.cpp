// SPDX-License-Identifier: BSD-3-Clause
#include "array_file.hpp"

#include <sys/mman.h>
#include <unistd.h>
#include <xxhash.h>

#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;
namespace ipc = boost::interprocess;

constexpr std::size_t kAlignment = 64;  // of each array in the file
constexpr std::size_t kMostArrays = 8;

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

/// Pages of the file are read ahead, all at once.
std::shared_ptr<const ipc::mapped_region> map(const std::string& file) {
  const ipc::file_mapping mapping(file.c_str(), ipc::read_only);
#if defined(MAP_POPULATE)
  return std::make_shared<const ipc::mapped_region>(mapping, ipc::read_only, 0, 0, nullptr,
                                                    MAP_SHARED | MAP_POPULATE);
#else
  return std::make_shared<const ipc::mapped_region>(mapping, ipc::read_only);
#endif
}

[[noreturn]] void reject(const std::string& file, const std::string& what) {
  throw std::runtime_error(file + ": " + what);
}

}  // namespace

ArrayFile::ArrayFile(const std::string& file, std::uint64_t key) : file_(file) {
  std::error_code error;
  if (fs::file_size(file, error) < sizeof(Header) || error) reject(file, "is cut short");
  std::shared_ptr<const ipc::mapped_region> region;
  try {
    region = map(file);
  } catch (const ipc::interprocess_exception& exception) {
    reject(file, std::string("cannot be read: ") + exception.what());
  }
  const char* data = static_cast<const char*>(region->get_address());
  Header header;
  std::memcpy(&header, data, sizeof(header));
  if (std::memcmp(header.name, kName, sizeof(kName)) != 0) reject(file, "is not an energy grid");
  if (header.byte_order != kByteOrder) reject(file, "was written on another kind of machine");
  if (header.version != kVersion) {
    reject(file, "has format version " + std::to_string(header.version) + ", expected " +
                     std::to_string(kVersion));
  }
  if (header.key != key) reject(file, "was made from something else");
  std::size_t end = aligned(sizeof(Header));
  for (const std::uint64_t size : header.sizes) {
    if (size > region->get_size() || end + size > region->get_size()) {
      reject(file, "is cut short");
    }
    if (size > 0) arrays_.push_back({data + end, static_cast<std::size_t>(size)});
    end += aligned(static_cast<std::size_t>(size));
  }
  if (checksumOf(header, arrays_) != header.checksum) reject(file, "is damaged (wrong checksum)");
  memory_ = std::move(region);
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

  const std::string part = file + "." + std::to_string(getpid()) + ".part";
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

}  // namespace adaptive_localization
