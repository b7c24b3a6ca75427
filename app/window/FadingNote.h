// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/LabelFade.h"

#include <QWidget>

namespace limn {

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

} // namespace limn
