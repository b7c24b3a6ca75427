// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "widgets/Gesture.h"

#include <QFrame>

namespace limn {

class ColorPicker;
enum class CurveSubject;
class PointFields;

/// Numbers and, where its curve has colours, colour of one control point beside it; closes on a click
/// elsewhere, Enter or Esc.
class PointPopup : public QFrame {
  Q_OBJECT

public:
  PointPopup(CurveSubject subject, const TransferFunction& function, std::size_t index, const QString& unit,
             int decimals, QWidget* parent);

  PointFields* fields() const { return m_fields; }

signals:
  void functionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);

private:
  void change(const TransferFunction& function, const Gesture& gesture);

  TransferFunction m_function;
  std::size_t m_index;
  QString m_unit;
  int m_decimals;
  PointFields* m_fields;
  ColorPicker* m_picker;
};

} // namespace limn
