// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"

#include <QAbstractButton>

#include <glm/glm.hpp>

namespace limn {

class ColorPicker;

/// A swatch that opens a ColorPicker below itself.
class ColorButton : public QAbstractButton {
  Q_OBJECT

public:
  /// `undoText` is what undo shows: "change colour".
  explicit ColorButton(const QString& undoText, QWidget* parent = nullptr);

  void setColor(const glm::dvec3& color);
  const glm::dvec3& color() const { return m_color; }

  QSize sizeHint() const override { return {36, 26}; }

signals:
  /// sRGB, 0..1.
  void colorEdited(const glm::dvec3& color, const limn::Gesture& gesture);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void openPicker();

  QString m_undoText;
  glm::dvec3 m_color{1.0};
};

} // namespace limn
