// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recovery/SessionKeeper.h"

class QMenu;

namespace limn {

class MessageBar;
class OpenDocument;

/// Sees to it that nobody loses a session of a window, and says so where it cannot: keeps the open one,
/// offers what dead windows left behind, and lists what was left unsaved.
class SessionSafety : public QObject {
  Q_OBJECT

public:
  /// What it says and offers through.
  struct Places {
    MessageBar& recovery; ///< offers what an earlier window left behind
    MessageBar& unsafe;   ///< says so as long as the session cannot be kept
    QMenu& unsaved;       ///< of sessions that were left unsaved
    QWidget& window;      ///< over which is asked
  };

  /// `session` tells the session of the moment.
  SessionSafety(const OpenDocument& document, std::function<SessionDocument()> session, const Places& places);

  /// From now on the session is autosaved below `folder`, and what an earlier window left behind is offered.
  void begin(const std::filesystem::path& folder);

  /// Says that the session may have changed.
  void noteChange();

  /// Puts the session of this moment on the disk when it is called, on any thread; empty while none is kept.
  std::function<void()> savingOfNow();

  /// Whether the scene may be left: it is kept, or the user says what becomes of it.
  bool mayLeave();

  /// The session that a kept file holds is open: from here on this window keeps it, and the file goes.
  void takeOver(const QString& file);

  /// Ends in order: nothing is left behind.
  void end();

  /// Fills the menu of unsaved sessions.
  void refreshMenu();

  /// Opens what was left unsaved last.
  void continueLast();

signals:
  void restoreRequested(const QString& file);
  void saveRequested();
  /// What was left unsaved last, as a few words that name nobody; empty: nothing.
  void unfinishedChanged(const QString& text);

private:
  bool askBeforeLosing(const QString& why);
  void sayUnsafe(const QString& why);
  void offerAbandoned();
  void tellUnfinished();

  const OpenDocument& m_document;
  std::function<SessionDocument()> m_session;
  Places m_places;
  std::unique_ptr<SessionKeeper> m_keeper; ///< null while sessions are not kept
  QString m_notKept;                       ///< why they are not, though they should be
};

} // namespace limn
