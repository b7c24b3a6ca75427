// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "widgets/Gesture.h"
#include "widgets/curve/picture/CurveEdits.h"

#include <QFrame>
#include <QWidget>

#include <cstdint>

class QLabel;

namespace limn {

class ColorButton;
class ColorPicker;
class NumberField;
enum class CurveSubject;

/// The numbers of the selected point to type: value, opacity, colour. Several points are given one opacity or
/// colour together, and none is shown as theirs where they differ; their values are moved in the plot.
class PointFields : public QWidget {
  Q_OBJECT

public:
  explicit PointFields(CurveSubject subject = CurveSubject::value, QWidget* parent = nullptr);

  /// `decimals` is what a value is shown with.
  void setPoints(const TransferFunction& function, const PointIndices& selected, const QString& unit,
                 int decimals);

  void focusValue();

  /// Gives the selected points a colour, by a gesture of a picker, and back the colours that they had before
  /// it.
  void pickColor(const glm::dvec3& color, std::uint64_t gestureId);
  void takeBackColor(std::uint64_t gestureId);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

signals:
  /// Enter or Esc ended typing in a number; what Esc had typed is taken back.
  void typingEnded(bool isTakenBack);
  /// The whole function with the selected points changed.
  void functionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);

private:
  void nameFields();
  void showCommon(NumberField& field, double ControlPoint::*number) const;
  QString describedSelection() const;

  CurveSubject m_subject;
  TransferFunction m_function;
  PointIndices m_selected;
  QString m_unit;
  QLabel* m_which;
  QLabel* m_opacityName;
  NumberField* m_value;
  NumberField* m_opacity;
  ColorButton* m_color;
  std::uint64_t m_picking = 0;   ///< the gesture that picks a colour
  TransferFunction m_beforePick; ///< the curve as it began
};

/// Numbers and, where its curve has colours, colour of control points beside one of them; closes on a click
/// elsewhere, Enter or Esc, which takes the colour back that was picked in it.
class PointPopup : public QFrame {
  Q_OBJECT

public:
  PointPopup(CurveSubject subject, const TransferFunction& function, const PointIndices& points,
             const QString& unit, int decimals, QWidget* parent);

  PointFields* fields() const { return m_fields; }

protected:
  void keyPressEvent(QKeyEvent* event) override;

signals:
  void functionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);

private:
  void change(const TransferFunction& function, const Gesture& gesture);

  PointIndices m_points;
  QString m_unit;
  int m_decimals;
  PointFields* m_fields;
  ColorPicker* m_picker;
};

} // namespace limn
