// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/curve/CurveDesk.h"

#include "scene/basics/Error.h"
#include "scene/light/GradientHistogram.h"
#include "widgets/Translated.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/properties/ProjectionSection.h"

#include <QMetaObject>

#include <exception>

namespace limn {

CurveDesk::CurveDesk(CurvePanel& panel, Settings& settings)
    : m_panel(panel), m_histograms(*panel.valueEditor(), settings) {
  connect(&m_histograms, &HistogramDesk::failed, this, &CurveDesk::failed);
  connect(&panel, &CurvePanel::gradientShown, this, &CurveDesk::measureGradients);
  panel.setVolumeOpen(false);
}

void CurveDesk::showScene(const Scene& scene) {
  m_panel.valueEditor()->setTransferFunction(scene.transferFunction);
  m_histograms.showScene(scene);
  m_panel.gradientEditor()->setGradientOpacity(scene.gradientOpacity);
  m_panel.setGradientState(!scene.gradientOpacity                  ? CurvePanel::GradientState::off
                           : usesGradientOpacity(scene.projection) ? CurvePanel::GradientState::on
                                                                   : CurvePanel::GradientState::unused);
}

void CurveDesk::showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram) {
  m_volume = volume;
  m_panel.setVolumeOpen(volume != nullptr);
  TransferFunctionEditor* editor = m_panel.valueEditor();
  m_histograms.showVolume(volume, histogram);
  editor->setUnit(volume ? QString::fromStdString(volume->info().unit) : QString());
  if (volume) {
    editor->setPinnedValue(std::nullopt);
    editor->canvas()->resetView(); // the points of the volume before no longer stretch the axis
  }
  measureGradients();
}

// Counting gradients takes a while and most scenes need none of it: it waits until somebody looks.
void CurveDesk::measureGradients() {
  GradientOpacityEditor* editor = m_panel.gradientEditor();
  editor->setUnit(m_volume ? QString::fromStdString(m_volume->info().unit) : QString());
  if (m_counted == m_volume)
    return;
  editor->setHistogram(std::nullopt);
  const bool begins = m_volume && m_panel.gradientIsShown();
  editor->setMeasuring(begins);
  m_counted = begins ? m_volume : nullptr;
  for (std::jthread& thread : m_threads)
    thread.request_stop();
  if (m_counted)
    m_threads.emplace_back(
        [this, volume = m_counted](const std::stop_token& stop) { countGradients(volume, stop); });
}

// On a worker thread. Only the volume asked for last counts.
void CurveDesk::countGradients(const std::shared_ptr<const Volume>& volume, const std::stop_token& stop) {
  Histogram gradients;
  QString problem;
  try {
    gradients = gradientHistogram(*volume, 1024, {0, [&stop] { return stop.stop_requested(); }, {}});
  } catch (const Cancelled&) {
    return;
  } catch (const std::exception& error) {
    problem = tr("The volume's gradients cannot be counted: %1.").arg(translated(error));
  }
  QMetaObject::invokeMethod(
      this,
      [this, volume, gradients, problem] {
        if (volume != m_counted)
          return;
        if (problem.isEmpty())
          m_panel.gradientEditor()->setHistogram(gradients);
        else
          emit failed(problem);
      },
      Qt::QueuedConnection);
}

} // namespace limn
