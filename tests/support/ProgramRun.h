// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/FileBytes.h"
#include "support/Places.h"

#include <cstdlib>

#include <sys/wait.h>

namespace limn::test {

/// How a run of the built program ended, and what it printed.
struct Outcome {
  int status = -1; ///< exit status; -1 where a signal ended it
  std::string out;
  std::string err;
};

/// Runs the built program without a display and with `home` as the user's home, as a shell does. `before`
/// goes in front of the command: variables, or limits of the shell. For tests declared with PROGRAM.
inline Outcome runProgram(const std::filesystem::path& home, const std::string& arguments,
                          const std::string& before = {}) {
  const std::filesystem::path out = home / "stdout", err = home / "stderr";
  const std::string command = before + " env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM HOME='" +
                              home.string() + "' '" + programPath() + "' " + arguments + " >'" +
                              out.string() + "' 2>'" + err.string() + "' </dev/null";
  const int raw = std::system(command.c_str());
  return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, bytesOfFile(out), bytesOfFile(err)};
}

} // namespace limn::test
