// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/curve/CurveController.h"

#include "app/window/WindowContext.h"
#include "scene/LabelLooks.h"
#include "scene/basics/Error.h"
#include "scene/framing/KeptVoxels.h"
#include "scene/light/GradientHistogram.h"
#include "scene/light/GradientSmoothing.h"
#include "widgets/Translated.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/HistogramButton.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/properties/ProjectionSection.h"
#include "widgets/theme/Theme.h"

#include <algorithm>

namespace limn {
namespace {

// A piece that was picked has a number among pieces, a label its own name.
QString nameOf(const Region& region, std::size_t label) {
  const std::size_t own = ownLabels(region);
  return label < own ? QString::fromStdString(region.labels->labels()[label].name)
                     : CurveController::tr("Piece %1").arg(label - own + 1);
}

// The values in which the piece hangs together that has a label; absent where none has.
std::optional<glm::dvec2> rangeOfPiece(const Region& keep, std::optional<std::size_t> label) {
  for (std::size_t n = 0; label && n < keep.cuts.size(); ++n)
    if (labelOfCut(keep, n) == label)
      return pieceWithLook(keep.cuts[n])->range;
  return std::nullopt;
}

const TransferFunction& curveOf(const Scene& scene, std::optional<std::size_t> label) {
  const std::size_t look = label ? lookOfLabel(scene.keep, *label) : 0;
  return look > 0 ? scene.keep.looks[look - 1] : scene.transferFunction;
}

} // namespace

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

void HistogramController::showScene(const Scene& scene, std::optional<std::size_t> label) {
  m_function = curveOf(scene, label);
  m_isOfLabel = label.has_value();
  m_ofPiece = rangeOfPiece(scene.keep, label);
  m_wanted.keep = scene.keep;
  if (label) {
    std::fill(m_wanted.keep.weights.begin(), m_wanted.keep.weights.end(), 0.0);
    m_wanted.keep.weights[*label] = 1.0;
    m_wanted.keep = {
        m_wanted.keep.kind, {}, m_wanted.keep.labels, m_wanted.keep.weights}; // whatever its look
  }
  m_wanted.crop = scene.crop;
  if (scene.volume == m_wanted.volume)
    show();
}

void HistogramController::show() {
  if (!m_wanted.volume)
    return;
  const bool isOfAll = (m_view.part == HistogramPart::whole && !m_isOfLabel) ||
                       KeptVoxels(m_wanted.volume->grid(), m_wanted.keep, m_wanted.crop).areAll();
  if (!isOfAll && m_known != m_wanted)
    return count();
  Histogram shown = isOfAll ? m_whole : m_kept;
  if (m_ofPiece) // it is grown into what surrounds it, so that its surface is drawn whole
    shown = heldWithin(std::move(shown), m_ofPiece->x, m_ofPiece->y);
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
  connect(m_panel.valueEditor(), &TransferFunctionEditor::transferFunctionEdited, this,
          &CurveController::edit);
  connect(&m_panel, &CurvePanel::curveChosen, this, &CurveController::takeInHand);
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

void CurveController::takeInHand(std::optional<std::size_t> label) {
  m_label = label;
  showScene(m_context.session.scene());
}

const TransferFunction& CurveController::curveInHand() const {
  return curveOf(m_context.session.scene(), m_label);
}

Scene CurveController::withCurveInHand(const TransferFunction& function) const {
  Scene next = m_context.session.scene();
  if (!m_label) {
    next.transferFunction = function;
    return next;
  }
  try {
    next.keep = withLookOf(next.keep, *m_label, function);
  } catch (const Error& error) { // too many looks
    m_context.showError(translated(error));
  }
  return next;
}

void CurveController::edit(const TransferFunction& function, const Gesture& gesture) {
  if (!m_label)
    return m_context.session.setTransferFunction(function, gesture);
  const QString name = nameOf(m_context.session.scene().keep, *m_label);
  const Scene next = withCurveInHand(function);
  if (next == m_context.session.scene())
    return showScene(next); // the canvas has what was refused
  m_context.session.edit(next, {gesture.id, tr("%1: %2").arg(name, gesture.text)});
}

// A label whose look is gone is in hand no longer.
void CurveController::showLabels(const Scene& scene) {
  if (m_label && lookOfLabel(scene.keep, *m_label) == 0)
    m_label.reset();
  m_colors.follow(scene.volume, scene.keep);
  QList<CurvePanel::LabelCurve> curves;
  for (std::size_t place = 0; place < scene.keep.lookOf.size(); ++place)
    if (lookOfLabel(scene.keep, place) > 0)
      curves.append({place, nameOf(scene.keep, place), toQColor(m_colors.of(place))});
  m_panel.setLabelCurves(curves, m_label);
}

void CurveController::showScene(const Scene& scene) {
  showLabels(scene);
  m_panel.valueEditor()->setTransferFunction(curveOf(scene, m_label));
  m_histograms.showScene(scene, m_label);
  m_smoothing = scene.shading.gradientSmoothing;
  measureGradients();
  m_panel.gradientEditor()->setGradientOpacity(scene.gradientOpacity);
  m_panel.setGradientState(!scene.gradientOpacity                  ? CurvePanel::GradientState::off
                           : usesGradientOpacity(scene.projection) ? CurvePanel::GradientState::on
                                                                   : CurvePanel::GradientState::unused);
}

void CurveController::showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram) {
  TransferFunctionEditor* editor = m_panel.valueEditor();
  if (volume != m_volume) {
    takeInHand(std::nullopt); // labels are those of the volume before
    editor->canvas()->forgetPointer();
    editor->canvas()->selectPoints({});
  }
  m_volume = volume;
  m_panel.setVolumeOpen(volume != nullptr);
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
  if (m_counted == m_volume && m_countedSmoothing == m_smoothing)
    return;
  editor->setHistogram(std::nullopt);
  const bool begins = m_volume && m_panel.gradientIsShown();
  editor->setMeasuring(begins);
  m_counted = begins ? m_volume : nullptr;
  m_countedSmoothing = m_smoothing;
  m_counting.cancel();
  if (!m_counted)
    return;
  m_counting.start([this, volume = m_counted,
                    smoothing = m_smoothing](const Effort& effort) -> BackgroundWork::Deliver {
    const Effort all{0, effort.isCancelled, {}};
    const bool isSmoothed = smoothsAnything(smoothing, volume->grid());
    Histogram gradients =
        gradientHistogram(isSmoothed ? *smoothedVolume(volume, smoothing, all) : *volume, 1024, all);
    return [this, gradients = std::move(gradients)] { m_panel.gradientEditor()->setHistogram(gradients); };
  });
}

} // namespace limn
