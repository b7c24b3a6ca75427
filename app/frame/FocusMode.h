// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The picture and its curve without what stands around them: panels, tool bars and status bar go while the
/// action is checked, and those that were there before come back with it. A note over the picture says how.
class FocusMode : public QObject {
  Q_OBJECT

public:
  explicit FocusMode(WindowContext& context);

  /// Brings everything back: a window is remembered as it is without this mode.
  void leave();

private:
  void set(bool isOn);

  WindowContext& m_context;
  QAction* m_action;
  FadingNote* m_note = nullptr;            ///< once there was something to say
  std::vector<QPointer<QWidget>> m_hidden; ///< beside the docks
};

} // namespace limn
