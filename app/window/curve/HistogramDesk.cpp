// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/curve/HistogramDesk.h"

#include "app/Settings.h"
#include "scene/basics/Error.h"
#include "scene/framing/KeptVoxels.h"
#include "widgets/Translated.h"
#include "widgets/curve/HistogramButton.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QMetaObject>

#include <exception>

namespace limn {

HistogramDesk::HistogramDesk(TransferFunctionEditor& editor, Settings& settings)
    : m_editor(editor), m_settings(settings), m_button(new HistogramButton),
      m_view(settings.histogramView()) {
  editor.addTrailing(m_button);
  m_button->setView(m_view);
  editor.canvas()->setHistogramScale(m_view.scale);
  connect(m_button, &HistogramButton::viewChosen, this, &HistogramDesk::choose);
}

void HistogramDesk::choose(const HistogramView& view) {
  m_view = view;
  m_settings.setHistogramView(view);
  m_editor.canvas()->setHistogramScale(view.scale);
  show();
}

void HistogramDesk::showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& whole) {
  m_whole = whole;
  m_wanted.volume = volume;
  m_shown = {};
  m_known = {};
  m_editor.setHistogram(whole);
  show();
}

void HistogramDesk::showScene(const Scene& scene) {
  m_function = scene.transferFunction;
  m_wanted.keep = scene.keep;
  m_wanted.crop = scene.crop;
  if (scene.volume == m_wanted.volume)
    show();
}

void HistogramDesk::show() {
  if (!m_wanted.volume)
    return;
  const bool isOfAll = m_view.part == HistogramPart::whole ||
                       KeptVoxels(m_wanted.volume->grid(), m_wanted.keep, m_wanted.crop).areAll();
  if (!isOfAll && m_known != m_wanted)
    return look();
  Histogram shown = isOfAll ? m_whole : m_kept;
  if (m_view.part == HistogramPart::visible)
    shown = shownBy(m_function, std::move(shown));
  if (shown == m_shown)
    return;
  m_shown = shown;
  m_editor.setHistogram(m_shown);
}

// One count at a time: what is wanted when it ends is counted next.
void HistogramDesk::look() {
  if (m_isCounting) {
    m_thread.request_stop();
    return;
  }
  m_isCounting = true;
  m_thread = std::jthread([this, of = m_wanted](const std::stop_token& stop) { count(of, stop); });
}

// On a worker thread.
void HistogramDesk::count(const Kept& of, const std::stop_token& stop) {
  std::optional<Histogram> counted;
  QString problem;
  try {
    counted = histogramOfKept(*of.volume, KeptVoxels(of.volume->grid(), of.keep, of.crop), 1024,
                              {0, [&stop] { return stop.stop_requested(); }, {}});
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    problem = tr("The voxels that are kept cannot be counted: %1.").arg(translated(error));
  }
  QMetaObject::invokeMethod(
      this, [this, of, counted, problem] { receive(of, counted, problem); }, Qt::QueuedConnection);
}

void HistogramDesk::receive(const Kept& of, const std::optional<Histogram>& counted, const QString& problem) {
  m_isCounting = false;
  if (!problem.isEmpty()) {
    emit failed(problem);
    return;
  }
  if (counted) {
    m_known = of;
    m_kept = *counted;
  }
  show();
}

} // namespace limn
