// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/volume/Volume.h"
#include "widgets/Gesture.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace limn {

/// The tissue of a value that was pinned in the picture, and two buttons that show less or more of it.
class TissueButtons : public QWidget {
  Q_OBJECT

public:
  explicit TissueButtons(QWidget* parent = nullptr);

  /// `unit` "HU" names the tissue; `range` is the volume's, `decimals` what values are told with.
  void setValue(double value, const QString& unit, const ValueRange& range, int decimals);

  void setTransferFunction(const TransferFunction& function) { m_function = function; }

signals:
  /// The whole function, with more or less opacity around the value.
  void functionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);

private:
  QToolButton* button(const QString& text, const QString& toolTip, double (*change)(double));

  TransferFunction m_function;
  double m_value = 0.0;
  QString m_unit;
  ValueRange m_range;
  QString m_text; ///< of the value
  QLabel* m_label;
};

} // namespace limn
