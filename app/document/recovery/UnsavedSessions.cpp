// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recovery/UnsavedSessions.h"

#include "app/core/naming/UserFolders.h"
#include "io/AtomicFile.h"
#include "scene/basics/Error.h"

#include <QDateTime>
#include <QRandomGenerator>

#include <algorithm>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostKept = 10;
const char* const openWindows = "windows";
const char* const closedSessions = "closed";
const char* const lockName = "lock";

std::string randomName() {
  return QString::number(QRandomGenerator::system()->generate64(), 36).toStdString();
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    entries.push_back(entry->path());
  return entries;
}

fs::file_time_type timeOf(const fs::path& file) {
  std::error_code unknown;
  const fs::file_time_type time = fs::last_write_time(file, unknown);
  return unknown ? fs::file_time_type::min() : time;
}

// A folder may vanish meanwhile: whoever closes a window removes its place.
std::optional<FileLock> lockIfThere(const fs::path& folder) {
  try {
    return FileLock::tryFor(folder / lockName);
  } catch (const Error&) {
    return std::nullopt;
  }
}

} // namespace

void AutosavePlace::remove() const {
  std::error_code failed;
  fs::remove(file(), failed); // first: a folder without it interests nobody
  fs::remove_all(m_folder, failed);
}

UnsavedSessions::UnsavedSessions(fs::path folder) : m_folder(std::move(folder)) {}

// Held while places are made and taken, so that nobody takes one that is half made.
FileLock UnsavedSessions::lockWhole() const {
  makePrivateFolder(m_folder);
  return FileLock::waitFor(m_folder / lockName);
}

AutosavePlace UnsavedSessions::place() const {
  const FileLock whole = lockWhole();
  const fs::path folder = m_folder / openWindows / randomName();
  makePrivateFolder(folder);
  return {folder, FileLock::waitFor(folder / lockName)};
}

std::vector<AutosavePlace> UnsavedSessions::takeAbandoned() const {
  const FileLock whole = lockWhole();
  std::vector<AutosavePlace> abandoned;
  for (const fs::path& folder : entriesOf(m_folder / openWindows)) {
    std::optional<FileLock> lock = lockIfThere(folder);
    if (!lock)
      continue; // its window lives, or has just gone
    AutosavePlace place(folder, std::move(*lock));
    if (fs::exists(place.file()))
      abandoned.push_back(std::move(place));
    else
      place.remove();
  }
  std::sort(abandoned.begin(), abandoned.end(), [](const AutosavePlace& a, const AutosavePlace& b) {
    return timeOf(a.file()) > timeOf(b.file());
  });
  return abandoned;
}

void UnsavedSessions::keep(const std::string& session) const {
  const fs::path folder = m_folder / closedSessions;
  makePrivateFolder(folder);
  // Names sort by time, and no two are the same.
  const QString time = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz-"));
  writeFileAtomically(folder / (time.toStdString() + randomName() + ".json"), session,
                      FilePlace::fixedPrivate);
  const std::vector<fs::path> all = kept();
  std::error_code failed;
  for (std::size_t i = mostKept; i < all.size(); ++i)
    fs::remove(all[i], failed);
}

std::vector<fs::path> UnsavedSessions::kept() const {
  std::vector<fs::path> files = entriesOf(m_folder / closedSessions);
  std::erase_if(files, [](const fs::path& file) { return file.extension() != ".json" || isTemporary(file); });
  std::sort(files.rbegin(), files.rend());
  return files;
}

} // namespace limn
