// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/light/Shading.h"
#include "scene/volume/Histogram.h"
#include "widgets/Gesture.h"

#include <QWidget>

#include <optional>

class QCheckBox;

namespace limn {

class TransferFunctionEditor;

/// Shows the curve of opacity over the gradient's modulus and asks for edits, in the plot of the transfer
/// function. A box switches it on, with a ramp from the volume's own gradients, and off.
class GradientOpacityEditor : public QWidget {
  Q_OBJECT

public:
  explicit GradientOpacityEditor(QWidget* parent = nullptr);

  /// Absent: the opacity follows the value alone.
  void setGradientOpacity(const std::optional<GradientOpacity>& curve);

  /// Of the gradient moduli; absent while they are not yet known, or without a volume.
  void setHistogram(const std::optional<Histogram>& histogram);

  /// Says that the histogram is being made; a histogram ends it.
  void setMeasuring(bool measuring);

  /// Of the values: the gradient's is this per mm.
  void setUnit(const QString& unit);

  TransferFunctionEditor* editor() const { return m_editor; }

signals:
  void gradientOpacityEdited(const std::optional<limn::GradientOpacity>& curve, const limn::Gesture& gesture);

private:
  void switchOn(bool on);
  void showState();

  std::optional<GradientOpacity> m_curve;
  std::optional<GradientOpacity> m_former; ///< of this volume, for switching on again
  std::optional<Histogram> m_histogram;
  bool m_measuring = false;
  QCheckBox* m_use;
  TransferFunctionEditor* m_editor;
};

/// A curve over the gradient as control points of one neutral colour, and back.
TransferFunction asControlPoints(const GradientOpacity& curve);
GradientOpacity asGradientOpacity(const TransferFunction& function);

} // namespace limn
