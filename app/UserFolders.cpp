// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/UserFolders.h"

#include "scene/basics/Error.h"

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
          standard(QStandardPaths::AppLocalDataLocation) / "sessions",
          standard(QStandardPaths::AppLocalDataLocation) / "reports"};
}

UserFolders UserFolders::below(const fs::path& folder) {
  return {folder / "settings" / "settings.json", folder / "presets", folder / "sessions", folder / "reports"};
}

void makeFolder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw Error(Error::Kind::other,
                Message::tr("Cannot make the folder %1: %2; make room there or allow Limn to write there.")
                    .arg(folder.string())
                    .arg(failed.message()));
}

void makePrivateFolder(const fs::path& folder) {
  std::error_code unknown;
  if (fs::is_directory(folder, unknown))
    return;
  makeFolder(folder);
  fs::permissions(folder, fs::perms::owner_all, unknown);
}

} // namespace limn
