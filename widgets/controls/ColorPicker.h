// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"

#include <QAbstractButton>
#include <QWidget>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

class QLineEdit;

namespace limn {

/// Picks a colour: a field of saturation (right) and brightness (up), a bar of hues, swatches of tissues, and
/// the hex code to type, or the English name. A tool tip names a swatch and its key. Live: every move of the
/// mouse reports, and all that is picked until another colour is set is one gesture, which can be taken back.
/// With the keyboard arrows move in the field (Shift: ten steps), Page Up and Page Down along the hues,
/// digits are the swatches from left to right.
class ColorPicker : public QWidget {
  Q_OBJECT

public:
  explicit ColorPicker(QWidget* parent = nullptr);

  void setColor(const glm::dvec3& color);

  /// Picks the colour that was set again, exactly; nothing where none was picked since.
  void takeBack();

  /// The keyboard goes to the code, all of which is replaced by what is typed.
  void focusCode();

  /// Why what was typed is no colour; empty once another is typed.
  const QString& refusal() const { return m_refusal; }

  QSize sizeHint() const override { return {236, 208}; }

signals:
  /// The user picked a colour, sRGB 0..1.
  void colorPicked(const glm::dvec3& color, std::uint64_t gestureId);
  /// What was picked by this gesture was taken back, behind colorPicked with the colour that was set: what
  /// had other colours than that has them again.
  void takenBack(std::uint64_t gestureId);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  enum class Part { none, field, hue };

  QRectF fieldRect() const;
  QRectF hueRect() const;
  QRectF shadesRect() const; ///< over which saturation and brightness run, and the ring is led
  QRectF huesRect() const;   ///< over which the hues run
  QRectF swatchRect(int index) const;
  std::optional<int> swatchAt(const QPointF& position) const;
  void pickAt(const QPointF& position);
  void pick(const QColor& color);
  void pickShown();
  void takeTyped();
  void refuse(const QString& refusal);
  QColor shown() const;
  void placeHex();
  void showColor(const QColor& color);
  void paintSwatches(QPainter& painter) const;

  // Kept apart, because grey has no hue and black no saturation to read back.
  double m_hue = 0.0;
  double m_saturation = 0.0;
  double m_brightness = 1.0;
  Part m_part = Part::none;
  glm::dvec3 m_before{1.0};      ///< that was set
  std::uint64_t m_gestureId = 0; ///< 0: nothing was picked since
  QString m_refusal;
  QLineEdit* m_hex;
};

/// Opens a ColorPicker with this colour in a pop-up beside `anchor` (global pixels), which closes on a click
/// elsewhere, on Enter, and on Esc, which takes back what was picked, as it says. The pop-up goes when it is
/// closed.
ColorPicker* openColorPicker(const glm::dvec3& color, const QRect& anchor, QWidget* parent);

/// A swatch that opens a ColorPicker below itself. Enter there keeps what was picked, Esc takes it back. One
/// of several colours shows each of them.
class ColorButton : public QAbstractButton {
  Q_OBJECT

public:
  /// `undoText` is what undo shows: "change colour".
  explicit ColorButton(const QString& undoText, QWidget* parent = nullptr);

  void setColor(const glm::dvec3& color) { setColors({color}); }
  /// At least one, from left to right; the picker begins with the first.
  void setColors(const std::vector<glm::dvec3>& colors);
  const glm::dvec3& color() const { return m_colors.front(); }

  QSize sizeHint() const override { return {36, 26}; }

signals:
  /// sRGB, 0..1.
  void colorEdited(const glm::dvec3& color, const limn::Gesture& gesture);
  /// As the picker's.
  void takenBack(std::uint64_t gestureId);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void openPicker();

  QString m_undoText;
  std::vector<glm::dvec3> m_colors{glm::dvec3(1.0)};
};

} // namespace limn
