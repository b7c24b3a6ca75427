// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/naming/UserFolders.h"

#include "io/AtomicFile.h"
#include "scene/basics/Error.h"

#include <cstdlib>

namespace limn {
namespace {

namespace fs = std::filesystem;

// A folder of the XDG base directories: where the environment says an absolute one, else below the home.
fs::path standard(const char* variable, const char* belowHome) {
  const auto said = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (const fs::path given = said(variable); given.is_absolute())
    return given;
  const fs::path home = said("HOME");
  return (home.empty() ? fs::path("/") : home) / belowHome;
}

} // namespace

UserFolders UserFolders::ofThisUser() {
  // Sessions name paths of this machine, so they do not roam with the user.
  const fs::path data = standard("XDG_DATA_HOME", ".local/share") / "limn" / "limn";
  return {standard("XDG_CONFIG_HOME", ".config") / "limn" / "settings.json", data / "presets",
          data / "sessions", data / "reports"};
}

UserFolders UserFolders::below(const fs::path& folder) {
  return {folder / "settings" / "settings.json", folder / "presets", folder / "sessions", folder / "reports"};
}

void makeFolder(const fs::path& folder) {
  if (const Message why = makeFolders(folder); !why.empty())
    throw Error(Error::Kind::other,
                Message::tr("Cannot make the folder %1: %2; make room there or allow Limn to write there.")
                    .arg(folder.string())
                    .arg(why));
}

void makePrivateFolder(const fs::path& folder) {
  std::error_code unknown;
  if (fs::is_directory(folder, unknown))
    return;
  makeFolder(folder);
  fs::permissions(folder, fs::perms::owner_all, unknown);
}

} // namespace limn
