// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/GradientOpacityEditor.h"

#include "scene/light/GradientHistogram.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QCheckBox>
#include <QVBoxLayout>

namespace limn {

TransferFunction asControlPoints(const GradientOpacity& curve) {
  constexpr glm::dvec3 neutral(0.62, 0.67, 0.73); // stands out on the dark and on the light plot
  TransferFunction function;
  for (const GradientOpacityPoint& point : curve.points)
    function.points.push_back({point.gradient, neutral, point.opacity});
  return function;
}

GradientOpacity asGradientOpacity(const TransferFunction& function) {
  GradientOpacity curve;
  for (const ControlPoint& point : function.points)
    curve.points.push_back({point.value, point.opacity});
  return curve;
}

GradientOpacityEditor::GradientOpacityEditor(QWidget* parent)
    : QWidget(parent), m_use(new QCheckBox(tr("Use this curve"))),
      m_editor(new TransferFunctionEditor(CurveSubject::gradient)) {
  m_use->setAccessibleName(tr("Use the curve of opacity over the gradient"));
  m_use->setToolTip(tr("<p>Multiplies the opacity by this curve, so that boundaries stay and even tissue "
                       "fades.</p><p>On or off, default off.</p>"));
  m_editor->addLeading(m_use);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_editor);
  setFocusProxy(m_editor);
  connect(m_use, &QAbstractButton::clicked, this, &GradientOpacityEditor::switchOn);
  connect(m_editor, &TransferFunctionEditor::transferFunctionEdited, this,
          [this](const TransferFunction& function, const Gesture& gesture) {
            m_curve = m_former = asGradientOpacity(function);
            emit gradientOpacityEdited(m_curve, gesture);
          });
  showState();
}

void GradientOpacityEditor::setGradientOpacity(const std::optional<GradientOpacity>& curve) {
  if (curve == m_curve)
    return;
  m_curve = curve;
  if (curve)
    m_former = curve;
  showState();
}

void GradientOpacityEditor::setHistogram(const std::optional<Histogram>& histogram) {
  m_histogram = histogram;
  m_measuring = false;
  if (!histogram)
    m_former = m_curve;
  m_editor->setHistogram(histogram.value_or(Histogram{}));
  showState();
}

void GradientOpacityEditor::setMeasuring(bool measuring) {
  m_measuring = measuring;
  showState();
}

void GradientOpacityEditor::setUnit(const QString& unit) {
  m_editor->setUnit(unit.isEmpty() ? tr("per mm") : tr("%1/mm").arg(unit));
}

void GradientOpacityEditor::switchOn(bool on) {
  if (on)
    m_curve = m_former ? *m_former : boundaryRamp(m_histogram.value_or(Histogram{}));
  else
    m_curve.reset();
  showState();
  emit gradientOpacityEdited(
      m_curve, {nextGestureId(), on ? tr("use opacity over gradient") : tr("drop opacity over gradient")});
}

void GradientOpacityEditor::showState() {
  const bool on = m_curve.has_value();
  m_use->setChecked(on);
  m_use->setEnabled(on || m_histogram);
  m_editor->setTransferFunction(on ? asControlPoints(*m_curve) : TransferFunction{});
  m_editor->setEditable(on);
  const QString off = tr("Off: opacity follows the value alone. Tick \"Use this curve\" to keep boundaries "
                         "and fade even tissue.");
  m_editor->canvas()->setHint(m_measuring          ? tr("Counting the volume's gradients…")
                              : on || !m_histogram ? QString()
                                                   : off);
}

} // namespace limn
