// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/LabelledRow.h"

#include <QStringList>
#include <QWidget>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace limn {

/// A track with one handle or two. A press on the track brings the nearest handle there; Shift drags ten
/// times finer, Esc takes the drag back; Left/Right, Page keys, Home and End move the handle that has the
/// focus, and the wheel does where the slider is focused. Two handles do not pass each other.
class TrackSlider : public QWidget {
  Q_OBJECT

public:
  TrackSlider(const SliderScale& scale, int handles, QWidget* parent = nullptr);

  /// Another track; the numbers stay.
  void setScale(const SliderScale& scale);
  const SliderScale& scale() const { return m_scale; }

  /// Ascending, one number per handle; numbers outside the scale sit at its ends.
  void setValues(const std::vector<double>& values);
  const std::vector<double>& values() const { return m_values; }

  /// Numbers the user picks are rounded to so many decimals; numbers set are not.
  void setDecimals(int decimals) { m_decimals = decimals; }

  /// What assistive technology calls the handles of a range, one name each.
  void setHandleNames(const QStringList& names) { m_handleNames = names; }
  const QStringList& handleNames() const { return m_handleNames; }

  /// How a number is read out, with its unit; without it as a bare number.
  void setReadOut(std::function<QString(double)> readOut) { m_readOut = std::move(readOut); }
  QString readOutOf(int handle) const;

  /// Moves a handle as a gesture of the user's own, up to its neighbours.
  void moveHandle(int handle, double value);

  /// Gives the focus to one handle.
  void focusHandle(int handle);
  int activeHandle() const { return m_active; }

  /// The part of the scale that a handle can go to, as another bounds it.
  SliderScale reachOf(int handle) const;

  /// How far an arrow key moves a handle from where it is.
  double keyStepOf(int handle) const;

  /// Where the coloured bar of a single handle starts; the left end unless set.
  void setOrigin(double value);

  /// Centre of a handle in widget coordinates.
  QPointF handleCentre(int handle) const;

  QSize sizeHint() const override { return {140, 20}; }
  QSize minimumSizeHint() const override;

signals:
  /// The user moved a handle. `gestureId` is shared by one drag.
  void valuesEdited(const std::vector<double>& values, std::uint64_t gestureId);
  /// The mouse button was released, or the drag taken back.
  void dragEnded();

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  bool focusNextPrevChild(bool next) override;

private:
  double trackWidth() const;
  int handleAt(double x) const;
  void moveActive(double value, std::uint64_t gestureId);
  void stepActive(double fraction, std::uint64_t gestureId);
  double valueUnder(double x) const;
  void endDrag();

  SliderScale m_scale;
  std::vector<double> m_values;
  QStringList m_handleNames;
  std::function<QString(double)> m_readOut;
  std::vector<double> m_before;
  double m_origin;
  int m_decimals = 9;
  int m_active = 0;
  bool m_dragging = false;
  double m_dragX = 0.0;
  double m_lastX = 0.0;
  std::uint64_t m_gestureId = 0;
};

} // namespace limn
