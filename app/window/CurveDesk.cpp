// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/CurveDesk.h"

#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/properties/ProjectionSection.h"

namespace limn {

CurveDesk::CurveDesk(CurvePanel& panel) : m_panel(panel) {
  connect(&panel, &CurvePanel::gradientShown, this, &CurveDesk::measureGradients);
  connect(&m_gradients, &GradientMeasurer::measured, panel.gradientEditor(),
          &GradientOpacityEditor::setHistogram);
  connect(&m_gradients, &GradientMeasurer::failed, this, &CurveDesk::failed);
}

void CurveDesk::showScene(const Scene& scene) {
  m_panel.valueEditor()->setTransferFunction(scene.transferFunction);
  m_panel.gradientEditor()->setGradientOpacity(scene.gradientOpacity);
  m_panel.setGradientState(!scene.gradientOpacity                  ? CurvePanel::GradientState::off
                           : usesGradientOpacity(scene.projection) ? CurvePanel::GradientState::on
                                                                   : CurvePanel::GradientState::unused);
}

void CurveDesk::showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram) {
  m_volume = volume;
  TransferFunctionEditor* editor = m_panel.valueEditor();
  editor->setHistogram(histogram);
  if (volume) {
    editor->setUnit(QString::fromStdString(volume->info().unit));
    editor->setPinnedValue(std::nullopt);
    editor->canvas()->resetView(); // the points of the volume before no longer stretch the axis
  }
  measureGradients();
}

// Counting gradients takes a while and most scenes need none of it: it waits until somebody looks.
void CurveDesk::measureGradients() {
  GradientOpacityEditor* editor = m_panel.gradientEditor();
  editor->setUnit(m_volume ? QString::fromStdString(m_volume->info().unit) : QString());
  if (m_gradients.volume() == m_volume)
    return;
  editor->setHistogram(std::nullopt);
  const bool begins = m_volume && m_panel.gradientIsShown();
  editor->setMeasuring(begins);
  m_gradients.measure(begins ? m_volume : nullptr);
}

} // namespace limn
