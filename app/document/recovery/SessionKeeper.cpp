// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recovery/SessionKeeper.h"

#include "app/core/naming/UserFolders.h"
#include "io/AtomicFile.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"

#include <QDateTime>
#include <QRandomGenerator>

#include <algorithm>
#include <iterator>
#include <mutex>

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

constexpr int againMs = 5000;
constexpr int mostTries = 12;

} // namespace

// What the threads share. It may outlive the object: a loader may still hold what saves.
struct Autosave::Shared {
  struct State {
    std::uint64_t number = 0; ///< later ones have larger numbers
    std::optional<SessionDocument> session;
  };

  std::filesystem::path file;
  std::mutex mutex; ///< guards what follows
  std::condition_variable_any wake;
  std::uint64_t lastNumber = 0;
  std::optional<State> waiting;
  /// Takes why writing failed, or that it did not; empty once the object is gone.
  std::function<void(const std::optional<QString>& problem)> tell;

  std::mutex writing; ///< guards what follows and the file
  std::uint64_t written = 0;
  std::optional<SessionDocument> onDisk;
  bool hasFailed = false;

  State numbered(std::optional<SessionDocument> session) {
    const std::lock_guard guard(mutex);
    return {++lastNumber, std::move(session)};
  }

  bool write(const State& state) {
    const std::lock_guard guard(writing);
    if (state.number <= written)
      return !hasFailed; // a later one came first
    written = state.number;
    if (!hasFailed && state.session == onDisk)
      return true;
    try {
      if (state.session)
        writeFileAtomically(file, sessionToJson(*state.session), FilePlace::fixedPrivate);
      else
        std::filesystem::remove(file);
      onDisk = state.session;
      hasFailed = false;
      report(std::nullopt);
    } catch (const std::exception& error) {
      hasFailed = true;
      report(translated(error));
    }
    return !hasFailed;
  }

  void report(const std::optional<QString>& problem) {
    const std::lock_guard guard(mutex);
    if (tell)
      tell(problem);
  }
};

Autosave::Autosave(std::filesystem::path file, std::function<std::optional<SessionDocument>()> current,
                   QObject* parent)
    : QObject(parent), m_shared(std::make_shared<Shared>()), m_current(std::move(current)) {
  m_shared->file = std::move(file);
  m_shared->tell = [this](const std::optional<QString>& problem) {
    QMetaObject::invokeMethod(
        this, [this, problem] { takeOutcome(problem); }, Qt::QueuedConnection);
  };
  m_timer.setSingleShot(true);
  m_timer.setInterval(intervalMs);
  connect(&m_timer, &QTimer::timeout, this, &Autosave::save);
  m_thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

Autosave::~Autosave() {
  m_thread.request_stop();
  m_thread.join();
  const std::lock_guard guard(m_shared->mutex);
  m_shared->tell = {};
}

void Autosave::takeOutcome(const std::optional<QString>& problem) {
  const bool isNew = m_problem.has_value() != problem.has_value();
  m_problem = problem;
  if (problem)
    noteChange(); // there may be room again although nothing changes
  if (isNew && problem)
    emit failed(*problem);
  else if (isNew)
    emit recovered();
}

// Not started anew by every change: a long gesture is saved on its way.
void Autosave::noteChange() {
  if (!m_timer.isActive())
    m_timer.start();
}

void Autosave::save() {
  if (!m_current)
    return;
  Shared::State state = m_shared->numbered(m_current());
  const std::lock_guard guard(m_shared->mutex);
  m_shared->waiting = std::move(state);
  m_shared->wake.notify_one();
}

std::function<bool()> Autosave::savingOfNow() {
  m_timer.stop();
  return [shared = m_shared, state = m_shared->numbered(m_current())] { return shared->write(state); };
}

void Autosave::work(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::unique_lock guard(m_shared->mutex);
    if (!m_shared->wake.wait(guard, stop, [this] { return m_shared->waiting.has_value(); }))
      return;
    const Shared::State state = std::move(*m_shared->waiting);
    m_shared->waiting.reset();
    guard.unlock();
    m_shared->write(state);
  }
}

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

SessionKeeper::SessionKeeper(const std::filesystem::path& folder,
                             std::function<std::optional<SessionDocument>()> current, QObject* parent)
    : QObject(parent), m_sessions(folder), m_abandoned(m_sessions.takeAbandoned()),
      m_place(m_sessions.place()),
      m_autosave(std::make_unique<Autosave>(m_place.file(), std::move(current))) {
  connect(&m_again, &QTimer::timeout, this, &SessionKeeper::lookAgain);
  m_again.start(againMs);
}

SessionKeeper::~SessionKeeper() = default;

void SessionKeeper::lookAgain() {
  if (++m_looks >= mostTries)
    m_again.stop();
  std::vector<AutosavePlace> more;
  try {
    more = m_sessions.takeAbandoned();
  } catch (const Error&) {
    m_again.stop(); // where the folder cannot be written, saving says so
  }
  if (more.empty())
    return;
  std::move(more.begin(), more.end(), std::back_inserter(m_abandoned));
  emit abandonedFound();
}

void SessionKeeper::close() {
  m_again.stop();
  m_autosave.reset();
  m_place.remove();
}

void SessionKeeper::keep(const SessionDocument& session) const {
  m_sessions.keep(sessionToJson(session));
}

std::optional<std::filesystem::path> SessionKeeper::abandoned() const {
  return m_abandoned.empty() ? std::nullopt : std::optional(m_abandoned.front().file());
}

void SessionKeeper::forget(const std::filesystem::path& file) {
  const auto found = std::find_if(m_abandoned.begin(), m_abandoned.end(),
                                  [&](const AutosavePlace& place) { return place.file() == file; });
  if (found == m_abandoned.end()) {
    std::error_code failed;
    std::filesystem::remove(file, failed);
    return;
  }
  found->remove();
  m_abandoned.erase(found);
}

} // namespace limn
