// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/drawing/EngineChoice.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/core/naming/UserFolders.h"
#include "app/document/OpenDocument.h"
#include "app/document/Settings.h"
#include "app/document/UndoStep.h"
#include "app/window/ActionList.h"
#include "app/window/Docks.h"
#include "scene/basics/MemoryBudget.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/view/drawing/DriverRecovery.h"

#include <QMainWindow>
#include <QString>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QStatusBar;
class QVBoxLayout;

namespace limn {

class CompareView;
class HintBar;
class PlaneDeck;

/// Says of whatever is saved that it was, or why not; what failed is forgotten once something is saved.
class SaveNotes {
public:
  SaveNotes(QStatusBar& status, MessageBar& messages) : m_status(status), m_messages(messages) {}

  /// Calls `write`, which throws Error where it fails; returns whether it did not. `path`, where there is
  /// one, is named in the status bar.
  bool attempt(const std::function<void()>& write, const QString& path = {});

  void sayFailure(const QString& sentence);

  /// The last failure, until something was saved; it may have been said by the window before.
  const QString& failure() const { return m_failure; }
  void takeOver(const QString& failure) { m_failure = failure; }

private:
  QStatusBar& m_status;
  MessageBar& m_messages;
  QString m_failure; ///< the last, until something was saved
};

/// Whoever shows the session's scene, in the order in which they are told of a new one: first what must know
/// it before the view draws, then the view and what shows the same beside it, then what asks the view.
class SceneFollowers {
public:
  enum class Stage { before, view, after };
  using Follow = std::function<void(const Scene& scene)>;

  /// Within a stage they are told in the order in which they were added.
  void add(Stage stage, Follow follow) {
    m_stages.at(static_cast<std::size_t>(stage)).push_back(std::move(follow));
  }

  void tell(const Scene& scene) const {
    for (const std::vector<Follow>& stage : m_stages)
      for (const Follow& follow : stage)
        follow(scene);
  }

private:
  std::array<std::vector<Follow>, 3> m_stages;
};

/// What the parts of a window share: what is open, what is remembered, where features register, and the
/// middle of the window. Parts know it and not each other.
struct WindowContext {
  /// Fills the middle of `window`. `folders` is where settings, presets and unsaved sessions are kept,
  /// `memory` how much it may take for volumes and what engines make of them (default: MemoryBudget's, each
  /// time). `open` comes from the window before; null: nothing is open.
  WindowContext(QMainWindow& window, UserFolders folders, const std::optional<MemoryBudget>& memory,
                std::unique_ptr<OpenWork> open = nullptr);

  /// Gives what is open to another window; nothing in this one changes it any more. What this returns must
  /// outlive the window.
  std::unique_ptr<OpenWork> giveOpen();

  /// What is known of who may draw, where the user wishes for `setting` (absent: whichever is faster).
  EngineFacts engineFacts(std::optional<Engine> setting);

  /// Pictures for files are drawn by whoever draws the window.
  MakingOptions drawnLikeTheView() const;

  /// Has a bar of the view keep clear of what is written over its lower edge, and stand above the messages
  /// where it has no room beside that.
  void keepClear(HintBar& bar) const;

  /// Says what went wrong in the bar above the picture.
  void showError(const QString& sentence) const;

  /// What the bar of messages says now is about the last undo step, and goes where that is undone or gone.
  void messageGoesWithLastStep();

  /// The message that is open, for a window that takes this one's place: there it stands as it was said,
  /// without what can be done about it.
  struct Said {
    std::optional<MessageBar::Said> message;
    QString ofStep; ///< the sentence about an undo step
    std::optional<UndoStep> step;
    QString failure; ///< to save
  };
  Said said() const;
  /// Where nothing newer is said.
  void takeOver(const Said& said);

private:
  // Before the session, whose undo stack tells of its end.
  QString m_saidOfStep;               ///< the sentence about an undo step
  std::optional<UndoStep> m_stepSaid; ///< that step; absent: of none anything is said
  std::unique_ptr<OpenWork> m_open;   ///< null once it was given away

public:
  QMainWindow& window;
  UserFolders folders;
  std::optional<MemoryBudget> memory;
  Settings settings;
  Session& session;
  OpenDocument& document;
  OpenGlOffer openGl = openGlOffer();
  ActionList actions;
  Docks docks;

private:
  QVBoxLayout& m_column; ///< of the middle
  MessageBar& addBar(const char* name);
  void placeBars();
  void leaveUndone();

public:
  MessageBar& recovery; ///< offers what an earlier window left behind
  MessageBar& unsafe;   ///< says so as long as the session cannot be kept
  MessageBar& kept;     ///< says that what was left with changes can be had back
  MessageBar& patient;  ///< asks once whether a patient may be named
  MessageBar& tour;     ///< offers a tour of the window, once
  MessageBar& messages;
  MessageBar& unwritten; ///< offers to save a drawn picture elsewhere that could not be written
  CompareView& view;
  PlaneDeck& planes; ///< around the view
  SaveNotes notes;
  SceneFollowers followers;
};

} // namespace limn
