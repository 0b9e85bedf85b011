// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "core/error_text.hpp"

namespace adaptive_localization {

/// A program's main: reads its arguments, prints the usage where they are wrong or ask for it, and
/// says in one line what goes wrong in `run`. Returns the exit code.
template <class Command>
int runProgram(const std::string& name, const std::string& usage,
               Command (*parse)(const std::vector<std::string>&), void (*run)(const Command&),
               const std::vector<std::string>& arguments) {
  Command command;
  try {
    command = parse(arguments);
  } catch (...) {
    std::cerr << name << ": " << errorText() << "\n\n" << usage;
    return EXIT_FAILURE;
  }
  if (command.wants_help) {
    std::cout << usage;
    return EXIT_SUCCESS;
  }
  try {
    run(command);
  } catch (...) {  // a plug-in may throw anything
    std::cerr << name << ": " << errorText() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace adaptive_localization
