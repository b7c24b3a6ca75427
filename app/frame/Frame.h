// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/frame/TourController.h"
#include "app/frame/dialogs/DialogController.h"
#include "widgets/view/overlay/Titles.h"

#include <QObject>
#include <QPointer>
#include <QWidget>

#include <vector>

class QAction;

namespace limn {

struct WindowContext;

/// A few words at the top of another widget that nobody need answer: they fade after some seconds, and take
/// neither pointer nor keyboard.
class FadingNote : public QWidget {
  Q_OBJECT

public:
  explicit FadingNote(QWidget& below);

  /// Shows the words anew.
  void say(const QString& text);

  const QString& text() const { return m_text; }

protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void place();

  QString m_text;
  LabelFade m_fade;
};

/// The picture alone: panels, curve, tool bars and status bar go while the action is checked, and those that
/// were there before come back with it. A note over the picture says how.
class FocusMode : public QObject {
  Q_OBJECT

public:
  explicit FocusMode(WindowContext& context);

  /// Brings everything back: a window is remembered as it is without this mode.
  void leave();

  bool isOn() const;
  void enter();

private:
  void set(bool isOn);

  WindowContext& m_context;
  QAction* m_action;
  FadingNote* m_note = nullptr;            ///< once there was something to say
  std::vector<QPointer<QWidget>> m_hidden; ///< beside the docks
};

/// What the window is called. Whether that tells whom the volume shows is asked once, of the first one that
/// says so; until it is answered nobody is named.
class TitleController : public QObject {
  Q_OBJECT

public:
  explicit TitleController(WindowContext& context);

  /// After another volume or session is open.
  void show();

private:
  void choose(bool isShown);
  void ask();

  WindowContext& m_context;
  QAction* m_patientInTitle; ///< the answer, which can be changed
};

/// Takes the keyboard from panel to panel, F6 forwards and Shift+F6 back, past those that are not seen; each
/// goes on where it was left.
class PanelCycle : public QObject {
  Q_OBJECT

public:
  /// Through `panels` in order, one within another named after it. All outlive it.
  PanelCycle(ActionList& actions, const QList<QWidget*>& panels);

private:
  struct Panel {
    QWidget* area;
    QPointer<QWidget> last; ///< in it that had the keyboard
  };

  Panel* panelOf(const QWidget* widget);
  void note(QWidget* now);
  void step(int direction);

  QList<Panel> m_panels;
};

/// What belongs to the window itself, whatever is open: its title, theme and language, the keys that lead
/// through it, its settings, help and tour. It is made last, and gives menus and docks their places.
class Frame : public QObject {
  Q_OBJECT

public:
  explicit Frame(WindowContext& context);

  TitleController& title() { return m_title; }
  TourController& tour() { return m_tour; }
  FocusMode& focusMode() { return m_focus; }
  const DialogController& dialogs() const { return m_dialogs; }

  /// What is seen of it, for a window that takes this one's place.
  struct Memory {
    bool isPictureOnly = false;
    bool offersTour = false;
    DialogController::Memory dialogs;
  };
  Memory memory() const;
  /// Once the window is shown.
  void takeOver(const Memory& memory);

signals:
  /// "system" or a code, as the settings have it from now on.
  void languageChosen(const QString& language);

private:
  void addLanguages();

  WindowContext& m_context;

  FocusMode m_focus;
  PanelCycle m_panels;
  TitleController m_title;
  DialogController m_dialogs;
  TourController m_tour;
};

} // namespace limn
