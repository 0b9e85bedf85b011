// SPDX-License-Identifier: BSD-3-Clause
#include "child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace adaptive_localization {
namespace {

constexpr rlim_t kMemory = rlim_t{2} << 30;       // bytes, more than at birth
constexpr std::size_t kBuffer = 1U << 18;         // bytes
constexpr itimerval kHeartbeat{{0, 0}, {60, 0}};  // s of the processor

void limit(decltype(RLIMIT_AS) what, rlim_t most) {
  rlimit now{};
  if (getrlimit(what, &now) != 0) return;
  now.rlim_cur = std::min(now.rlim_max, most);
  setrlimit(what, &now);
}

/// So that what it asks for in error is refused, and not taken from others.
void limitMemory() {
  rlim_t pages = 0;
  if (std::ifstream("/proc/self/statm") >> pages) {
    limit(RLIMIT_AS, pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + kMemory);
  }
}

/// Whoever started us says when to end, by reading no more; and has the say on the terminal.
void settle() {
  for (const int signal : {SIGINT, SIGTERM}) ::signal(signal, SIG_IGN);
  for (const int signal : {SIGPIPE, SIGPROF}) ::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limitMemory();
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  ChildProcess::beat();
}

[[noreturn]] void run(const std::function<void(std::FILE*)>& work, int descriptor) {
  settle();
  std::FILE* out = fdopen(descriptor, "wb");
  bool is_sent = false;
  try {
    std::setvbuf(out, nullptr, _IOFBF, kBuffer);
    work(out);
    is_sent = std::fflush(out) == 0;
  } catch (...) {  // what it sent lacks an end
  }
  _exit(is_sent ? EXIT_SUCCESS : EXIT_FAILURE);  // nothing of what it inherited is its to clean up
}

[[noreturn]] void fail() {
  throw std::runtime_error(std::string("a process cannot be started: ") + std::strerror(errno));
}

}  // namespace

ChildProcess::ChildProcess(const std::function<void(std::FILE*)>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail();
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    run(work, ends[1]);
  }
  close(ends[1]);
  received_ = fdopen(ends[0], "rb");
  if (process_ > 0) return;
  std::fclose(received_);
  fail();
}

ChildProcess::~ChildProcess() {
  std::fclose(received_);
  if (process_ != 0) end();
}

void ChildProcess::beat() {
  setitimer(ITIMER_PROF, &kHeartbeat, nullptr);
}

bool ChildProcess::read(void* data, std::size_t size) {
  return size == 0 || std::fread(data, 1, size, received_) == size;
}

std::string ChildProcess::end() {
  kill(process_, SIGKILL);  // one that is ending already keeps its own reason
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = 0;
  if (WIFSIGNALED(status)) return strsignal(WTERMSIG(status));
  return "exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace adaptive_localization
