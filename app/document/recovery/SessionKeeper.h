// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/FileLock.h"
#include "io/scenefile/SessionFile.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace limn {

/// Keeps a file at the state of a session, atomically and on a thread of its own: at most every two seconds,
/// and whenever somebody asks. Signals come on the thread it lives in.
class Autosave : public QObject {
  Q_OBJECT

public:
  /// `current` tells the session of the moment; absent: there is nothing that could be lost, and no file is
  /// kept.
  Autosave(std::filesystem::path file, std::function<std::optional<SessionDocument>()> current,
           QObject* parent = nullptr);
  ~Autosave() override;

  static constexpr int intervalMs = 2000;

  /// From now on `current` tells the session; empty: nobody does, and the file stays as it is.
  void follow(std::function<std::optional<SessionDocument>()> current) { m_current = std::move(current); }

  /// Why what changed last is not on the disk; absent where it is, or soon will be.
  const std::optional<QString>& problem() const { return m_problem; }

  /// Says that the session may have changed.
  void noteChange();

  /// Writes the session of this moment when it is called, on the thread that calls it; for whoever begins
  /// something that may end the process. Returns whether it, or a later one, is on the disk; failures are
  /// signalled as well.
  std::function<bool()> savingOfNow();

signals:
  /// The sentence says why what changed since is not on the disk; told once until it succeeds again. It is
  /// tried again every two seconds.
  void failed(const QString& sentence);
  /// What failed does no longer.
  void recovered();

private:
  struct Shared;
  void save();
  void takeOutcome(const std::optional<QString>& problem);
  void work(const std::stop_token& stop);

  std::shared_ptr<Shared> m_shared;
  std::function<std::optional<SessionDocument>()> m_current;
  QTimer m_timer;
  std::optional<QString> m_problem;
  std::jthread m_thread;
};

/// A folder that holds the autosaved session of one window, locked for as long as this object lives.
class AutosavePlace {
public:
  AutosavePlace(std::filesystem::path folder, FileLock lock)
      : m_folder(std::move(folder)), m_lock(std::move(lock)) {}

  std::filesystem::path file() const { return m_folder / "session.json"; }

  /// Removes folder and session. The place is then of no further use.
  void remove() const;

private:
  std::filesystem::path m_folder;
  FileLock m_lock;
};

/// Sessions that nobody saved: those of open windows, those that were left behind by windows whose process
/// ended without closing them, and the last ten that were closed or replaced with unsaved changes. Safe
/// among processes.
class UnsavedSessions {
public:
  explicit UnsavedSessions(std::filesystem::path folder);

  /// A new place. Throws Error where the folder cannot be written.
  AutosavePlace place() const;

  /// The places of dead windows that hold a session, latest first; each goes to one caller only for as long
  /// as that one lives. What else dead windows left is removed. Throws Error.
  std::vector<AutosavePlace> takeAbandoned() const;

  /// Keeps a session that is closed or replaced. Throws Error.
  void keep(const std::string& session) const;

  /// Files of the kept ones, latest first.
  std::vector<std::filesystem::path> kept() const;

private:
  FileLock lockWhole() const;

  std::filesystem::path m_folder;
};

/// Sees to it that the session of one window is not lost: saves it all the time, keeps what is left unsaved,
/// and knows what windows left behind whose process ended without closing them.
class SessionKeeper : public QObject {
  Q_OBJECT

public:
  /// `current` as for Autosave. Throws Error where `folder` cannot be written.
  SessionKeeper(const std::filesystem::path& folder, std::function<std::optional<SessionDocument>()> current,
                QObject* parent = nullptr);
  ~SessionKeeper() override;

  Autosave& autosave() { return *m_autosave; }

  /// Ends in order: nothing is left behind. Without it, the session counts as abandoned.
  void close();

  /// Keeps a session that is about to be left unsaved. Throws Error.
  void keep(const SessionDocument& session) const;
  /// Files of those kept, latest first.
  std::vector<std::filesystem::path> kept() const { return m_sessions.kept(); }

  /// The latest session that a dead window left behind; nobody else is offered it.
  std::optional<std::filesystem::path> abandoned() const;

  /// Looks again for what dead windows left behind; done every few seconds of the first minute, because a
  /// process that crashed may take a while to die (it writes its memory to the disk).
  void lookAgain();

  /// Removes a session that was restored or is not wanted, one of those above.
  void forget(const std::filesystem::path& file);

signals:
  /// There is one more to offer.
  void abandonedFound();

private:
  UnsavedSessions m_sessions;
  std::vector<AutosavePlace> m_abandoned;
  AutosavePlace m_place;
  std::unique_ptr<Autosave> m_autosave; ///< null once closed
  QTimer m_again;
  int m_looks = 0;
};

} // namespace limn
