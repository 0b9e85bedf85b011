// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace adaptive_localization {

/// A folder of this process, in memory, where readers find what they are to read.
class InputFolder {
 public:
  InputFolder() {
    const bool has_memory = std::filesystem::exists("/dev/shm");
    std::string name = std::string(has_memory ? "/dev/shm" : "/tmp") + "/fuzz_XXXXXX";
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a folder like " + name);
    path_ = name;
  }
  ~InputFolder() { std::filesystem::remove_all(path_); }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

  std::string write(const std::string& name, const std::string& contents) const {
    std::ofstream(file(name), std::ios::binary) << contents;
    return file(name);
  }

 private:
  std::string path_;
};

inline const InputFolder& inputFolder() {
  static const InputFolder folder;
  return folder;
}

/// Lets a reader read; it may refuse by std::exception, and by nothing else.
template <class Read>
int tryToRead(const Read& read) {
  try {
    read();
  } catch (const std::exception&) {  // refused
  }
  return 0;
}

/// Lets a reader read what was written from what it read before: it may not refuse that.
template <class Read>
void readAgain(const Read& read) noexcept {
  read();
}

/// Gives the bytes as a file to a reader of files.
template <class Read>
int tryFile(const std::uint8_t* data, std::size_t size, const std::string& name, const Read& read) {
  const std::string file =
      inputFolder().write(name, std::string(reinterpret_cast<const char*>(data), size));
  return tryToRead([&] { read(file); });
}

}  // namespace adaptive_localization
