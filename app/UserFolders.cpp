// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/UserFolders.h"

#include <QStandardPaths>

namespace limn {
namespace {

namespace fs = std::filesystem;

fs::path standard(QStandardPaths::StandardLocation location) {
  return QStandardPaths::writableLocation(location).toStdString();
}

} // namespace

UserFolders UserFolders::ofThisUser() {
  // Sessions name paths of this machine, so they do not roam with the user.
  return {standard(QStandardPaths::GenericConfigLocation) / "limn" / "settings.json",
          standard(QStandardPaths::AppDataLocation) / "presets",
          standard(QStandardPaths::AppLocalDataLocation) / "sessions"};
}

UserFolders UserFolders::below(const fs::path& folder) {
  return {folder / "settings" / "settings.json", folder / "presets", folder / "sessions"};
}

void makePrivateFolder(const fs::path& folder) {
  std::error_code failed;
  if (fs::create_directories(folder, failed))
    fs::permissions(folder, fs::perms::owner_all, failed);
}

} // namespace limn
