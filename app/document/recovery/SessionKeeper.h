// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recovery/Autosave.h"
#include "app/document/recovery/UnsavedSessions.h"

#include <QTimer>

namespace limn {

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
