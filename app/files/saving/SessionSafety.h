// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recovery/SessionKeeper.h"

class QMenu;

namespace limn {

struct WindowContext;

/// Sees to it that nobody loses a session of a window, and says so where it cannot: keeps the open one,
/// offers what dead windows left behind, and lists what was left unsaved.
class SessionSafety : public QObject {
  Q_OBJECT

public:
  /// `session` tells the session of the moment.
  SessionSafety(WindowContext& context, std::function<SessionDocument()> session);

  /// From now on the session is autosaved, and what an earlier window left behind is offered. `keeper` goes
  /// on with what it kept for the window before; null: there was none.
  void begin(std::unique_ptr<SessionKeeper> keeper = nullptr);

  /// Whether sessions are kept, or should be.
  bool keeps() const { return m_keeper || !m_notKept.isEmpty(); }

  /// Gives the keeper to another window: what is on the disk stays there meanwhile. Null: there is none.
  std::unique_ptr<SessionKeeper> giveKeeper();

  /// Says that the session may have changed.
  void noteChange();

  /// Puts the session of this moment on the disk when it is called, on any thread; empty while none is kept.
  std::function<void()> savingOfNow();

  /// Keeps what is unsaved, to be opened again. Why that failed, a sentence; absent where nothing is lost.
  std::optional<QString> keepUnsaved();

  /// Whether the scene may be left: it is kept, or the user says what becomes of it.
  bool mayLeave();

  /// The page without a volume, which offers what was left with changes, will not be seen: that is said once
  /// the first volume is shown.
  void sayWithFirst() { m_saysWithFirst = true; }

  /// Once something else is shown: says that what was left with changes is kept, and earlier work on the
  /// volume that is open now, and offers them.
  void sayWhatIsKept();

  /// Kept sessions to tell of; empty: none.
  struct Kept {
    std::filesystem::path left;            ///< what was open before
    std::filesystem::path ofThis;          ///< the latest of the volume that is open now
    std::optional<std::string> label = {}; ///< of what was just left with changes
  };
  /// What is told and offered at present; absent: nothing, or no longer.
  std::optional<Kept> told() const;
  /// Tells and offers it again, in the language of now.
  void tellAgain(const Kept& kept);

  /// The session that a kept file holds is open: from here on this window keeps it, and the file goes, unless
  /// it is not open as a whole: then it alone has the rest.
  void takeOver(const QString& file, bool isWhole);

  /// Ends in order: nothing is left behind.
  void end();

signals:
  void restoreRequested(const QString& file);
  void saveRequested();

private:
  /// Fills the menu of unsaved sessions.
  void refreshMenu();
  /// Opens what was left unsaved last.
  void continueLast();
  bool askBeforeLosing(const QString& why);
  void sayUnsafe(const QString& why);
  void offerAbandoned();
  void tellUnfinished();
  /// `hasLeft`: something was just left with changes; `isFirst`: nothing was shown before.
  Kept keptNow(bool hasLeft, bool isFirst) const;

  WindowContext& m_context;
  QMenu* m_unsaved; ///< of sessions that were left unsaved
  std::function<SessionDocument()> m_session;
  std::unique_ptr<SessionKeeper> m_keeper; ///< null while sessions are not kept
  QString m_notKept;                       ///< why they are not, though they should be
  bool m_saysWithFirst = false;
  Kept m_told;                       ///< last
  std::optional<std::string> m_left; ///< what was left with changes and is kept, until that is said
};

} // namespace limn
