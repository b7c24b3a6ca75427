// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/curve/HistogramController.h"

#include "app/document/Settings.h"
#include "scene/framing/KeptVoxels.h"
#include "widgets/curve/HistogramButton.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

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

} // namespace limn
