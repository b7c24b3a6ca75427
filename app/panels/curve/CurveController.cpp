// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/curve/CurveController.h"

#include "app/window/WindowContext.h"
#include "scene/framing/KeptVoxels.h"
#include "scene/light/GradientHistogram.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/HistogramButton.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/properties/ProjectionSection.h"

namespace limn {

HistogramController::HistogramController(TransferFunctionEditor& editor, Settings& settings)
    : m_editor(editor), m_settings(settings), m_button(new HistogramButton),
      m_view(settings.histogramView()) {
  editor.addTrailing(m_button);
  m_button->setView(m_view);
  editor.canvas()->setHistogramScale(m_view.scale);
  connect(m_button, &HistogramButton::viewChosen, this, &HistogramController::choose);
  connect(&m_counting, &BackgroundWork::failed, this, [this](const QString& why) {
    emit failed(tr("The voxels that are kept cannot be counted: %1.").arg(why));
  });
}

void HistogramController::choose(const HistogramView& view) {
  m_view = view;
  m_settings.setHistogramView(view);
  m_editor.canvas()->setHistogramScale(view.scale);
  show();
}

void HistogramController::showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& whole) {
  m_whole = whole;
  m_wanted.volume = volume;
  m_shown = {};
  m_known = {};
  m_editor.setHistogram(whole);
  show();
}

void HistogramController::showScene(const Scene& scene) {
  m_function = scene.transferFunction;
  m_wanted.keep = scene.keep;
  m_wanted.crop = scene.crop;
  if (scene.volume == m_wanted.volume)
    show();
}

void HistogramController::show() {
  if (!m_wanted.volume)
    return;
  const bool isOfAll = m_view.part == HistogramPart::whole ||
                       KeptVoxels(m_wanted.volume->grid(), m_wanted.keep, m_wanted.crop).areAll();
  if (!isOfAll && m_known != m_wanted)
    return count();
  Histogram shown = isOfAll ? m_whole : m_kept;
  if (m_view.part == HistogramPart::visible)
    shown = shownBy(m_function, std::move(shown));
  if (shown == m_shown)
    return;
  m_shown = shown;
  m_editor.setHistogram(m_shown);
}

void HistogramController::count() {
  if (m_counting.isRunning() && m_inWork == m_wanted)
    return;
  m_inWork = m_wanted;
  m_counting.start([this, of = m_wanted](const Effort& effort) -> BackgroundWork::Deliver {
    Histogram counted = histogramOfKept(*of.volume, KeptVoxels(of.volume->grid(), of.keep, of.crop), 1024,
                                        {0, effort.isCancelled, {}});
    return [this, of, counted = std::move(counted)] {
      m_known = of;
      m_kept = counted;
      show();
    };
  });
}

CurveController::CurveController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_panel(*new CurvePanel(&context.window)),
      m_histograms(*m_panel.valueEditor(), context.settings) {
  context.docks.add({tr("Transfer f&unction"), "curveDock", &m_panel, Qt::BottomDockWidgetArea});
  connect(m_panel.valueEditor(), &TransferFunctionEditor::transferFunctionEdited, &context.session,
          &Session::setTransferFunction);
  connect(m_panel.gradientEditor(), &GradientOpacityEditor::gradientOpacityEdited, &context.session,
          &Session::setGradientOpacity);
  connect(&m_histograms, &HistogramController::failed, this,
          [this](const QString& sentence) { m_context.showError(sentence); });
  connect(&m_counting, &BackgroundWork::failed, this, [this](const QString& why) {
    m_context.showError(tr("The volume's gradients cannot be counted: %1.").arg(why));
  });
  connect(&m_panel, &CurvePanel::gradientShown, this, &CurveController::measureGradients);
  context.followers.add(SceneFollowers::Stage::view, [this](const Scene& scene) { showScene(scene); });
  m_panel.setVolumeOpen(false);
}

void CurveController::showScene(const Scene& scene) {
  m_panel.valueEditor()->setTransferFunction(scene.transferFunction);
  m_histograms.showScene(scene);
  m_panel.gradientEditor()->setGradientOpacity(scene.gradientOpacity);
  m_panel.setGradientState(!scene.gradientOpacity                  ? CurvePanel::GradientState::off
                           : usesGradientOpacity(scene.projection) ? CurvePanel::GradientState::on
                                                                   : CurvePanel::GradientState::unused);
}

void CurveController::showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram) {
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
void CurveController::measureGradients() {
  GradientOpacityEditor* editor = m_panel.gradientEditor();
  editor->setUnit(m_volume ? QString::fromStdString(m_volume->info().unit) : QString());
  if (m_counted == m_volume)
    return;
  editor->setHistogram(std::nullopt);
  const bool begins = m_volume && m_panel.gradientIsShown();
  editor->setMeasuring(begins);
  m_counted = begins ? m_volume : nullptr;
  m_counting.cancel();
  if (!m_counted)
    return;
  m_counting.start([this, volume = m_counted](const Effort& effort) -> BackgroundWork::Deliver {
    Histogram gradients = gradientHistogram(*volume, 1024, {0, effort.isCancelled, {}});
    return [this, gradients = std::move(gradients)] { m_panel.gradientEditor()->setHistogram(gradients); };
  });
}

} // namespace limn
