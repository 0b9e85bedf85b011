// SPDX-License-Identifier: BSD-3-Clause
#include "stop_signal.hpp"

#include <errno.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>

namespace adaptive_localization {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

void say(const char* text) {
  [[maybe_unused]] const auto said = write(STDERR_FILENO, text, std::strlen(text));
}

void onSignal(int signal) {
  constexpr unsigned kPatience = 10;  // s
  stop_requested = 1;
  std::signal(signal, SIG_DFL);
  alarm(kPatience);
}

void onAlarm(int) {
  say(program_invocation_short_name);
  say(": ended without the ROS master's answer\n");
  std::_Exit(EXIT_FAILURE);
}

}  // namespace

void catchStopSignals() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  std::signal(SIGALRM, onAlarm);
}

bool isStopRequested() {
  return stop_requested != 0;
}

}  // namespace adaptive_localization
