// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/temp_folder.hpp"

namespace adaptive_localization {

/// How a program ended and what it said.
struct ProgramResult {
  int exit_code{-1};  // -1: killed by a signal
  std::string output, errors;
};

inline std::string readWhole(const std::string& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

/// Runs a program to its end; arguments may hold anything but a single quote.
inline ProgramResult runProgram(const std::string& program,
                                const std::vector<std::string>& arguments) {
  const TempFolder folder;
  std::string command = "'" + program + "'";
  for (const auto& argument : arguments) command += " '" + argument + "'";
  command += " >'" + folder.file("out") + "' 2>'" + folder.file("err") + "'";
  const int status = std::system(command.c_str());
  ProgramResult result;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  result.output = readWhole(folder.file("out"));
  result.errors = readWhole(folder.file("err"));
  return result;
}

}  // namespace adaptive_localization
