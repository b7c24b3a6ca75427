// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/Places.h"
#include "support/Sanitizers.h"
#include "support/Shell.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <set>

namespace limn::test {

/// Tests with a tree of their own into which the built program was installed, below tree()/usr.
class Installed : public testing::Test {
protected:
  void SetUp() override {
    if (isSanitised)
      GTEST_SKIP() << "a program under a sanitizer is linked with what is never installed";
    const Said outcome = run("DESTDIR='" + tree().string() + "' cmake --install '" + buildFolder().string() +
                             "' --prefix /usr --strip");
    ASSERT_EQ(outcome.status, 0) << outcome.text;
  }

  std::filesystem::path tree() const { return m_folder.path() / "tree"; }
  std::filesystem::path file(const std::string& name) const { return m_folder.path() / name; }
  std::filesystem::path share(const std::string& name) const { return tree() / "usr/share" / name; }

  /// A command of the shell, run in the test's folder, which is the user's home, without a display.
  Said run(const std::string& command) const {
    return said(m_folder.path(), "unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM; export HOME='" +
                                     m_folder.path().string() + "'; " + command);
  }

private:
  TemporaryFolder m_folder;
};

/// Every path below a folder, relative to it.
inline std::set<std::string> pathsBelow(const std::filesystem::path& folder) {
  std::set<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    paths.insert(std::filesystem::relative(entry.path(), folder).string());
  return paths;
}

} // namespace limn::test
