// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/WindowHarness.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace limn::test {

/// Windows that end, or die, one after the other over the same folder of kept sessions.
class KeepingWindow : public WindowHarness {
protected:
  std::filesystem::path sessions() const { return folder.path() / "sessions"; }

  /// The autosaved sessions on the disk.
  std::vector<std::filesystem::path> autosaved() const {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::exists(sessions() / "windows"))
      for (const auto& entry : std::filesystem::directory_iterator(sessions() / "windows"))
        if (std::filesystem::exists(entry.path() / "session.json"))
          files.push_back(entry.path() / "session.json");
    return files;
  }

  [[nodiscard]] bool waitForAutosave() {
    return waitUntil([this] { return !autosaved().empty(); });
  }

  /// The window dies without closing: what a killed process leaves.
  void die() { window.reset(); }

  /// Another one, which keeps no sessions yet.
  std::unique_ptr<MainWindow> newWindow() {
    auto made = std::make_unique<MainWindow>(UserFolders::below(folder.path()));
    made->view().setRefinesAtRest(false);
    made->resize(900, 640);
    made->show();
    return made;
  }
};

} // namespace limn::test
