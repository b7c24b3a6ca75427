// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/FileBytes.h"

#include <cstdlib>

#include <sys/wait.h>

namespace limn::test {

/// How a command ended, and what it printed on stdout and stderr together.
struct Said {
  int status = -1; ///< exit status; -1 where a signal ended it
  std::string text;
};

/// Runs a command of the shell in a folder, in which it leaves the file "said".
inline Said said(const std::filesystem::path& folder, const std::string& command) {
  const std::filesystem::path out = folder / "said";
  const int raw = std::system(
      ("cd '" + folder.string() + "' && { " + command + "\n} >'" + out.string() + "' 2>&1 </dev/null")
          .c_str());
  return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, bytesOfFile(out)};
}

/// Whether the shell finds a program of that name.
inline bool isOnThePath(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

} // namespace limn::test
