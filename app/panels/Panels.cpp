// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/Panels.h"

#include "app/panels/EffectSwitches.h"
#include "app/window/WindowContext.h"
#include "scene/function/PointShare.h"
#include "scene/presets/PresetFit.h"
#include "widgets/controls/LabelledRow.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/PointLight.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/EffectsPanel.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/Overlay.h"

#include <QStyledItemDelegate>
#include <QUndoView>

#include <algorithm>

#include <memory>

namespace limn {
namespace {

// In Hounsfield units. Air around the body is left out of a minimum, and of an average but for its depth.
TransferFunction minimumCurve() {
  return {1.0,
          {{-985.0, glm::dvec3(0.0), 0.0},
           {-985.0, glm::dvec3(0.0), 1.0},
           {-200.0, glm::dvec3(0.55), 1.0},
           {100.0, glm::dvec3(1.0), 1.0}}};
}

TransferFunction averageCurve() {
  return {1.0,
          {{-950.0, glm::dvec3(0.0), 0.0},
           {-950.0, glm::dvec3(0.0), 1.0},
           {-300.0, glm::dvec3(0.45), 1.0},
           {500.0, glm::dvec3(1.0), 1.0}}};
}

// Edits are named as undo says them, "move point"; a list of them begins each with a capital, and those that
// are undone step back.
class HistoryDelegate : public QStyledItemDelegate {
public:
  HistoryDelegate(const QUndoStack& stack, QObject* parent) : QStyledItemDelegate(parent), m_stack(stack) {}

  QString displayText(const QVariant& value, const QLocale& locale) const override {
    QString text = QStyledItemDelegate::displayText(value, locale);
    if (!text.isEmpty())
      text[0] = text[0].toUpper();
    return text;
  }

  // Lines end within the rows: the view tells its whole width, frame and scroll bar included.
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto* list = qobject_cast<const QListView*>(option.widget);
    if (!list)
      return QStyledItemDelegate::sizeHint(option, index);
    QStyleOptionViewItem within = option;
    const int width = list->viewport()->width() - 2 * list->spacing();
    // The style measures the text in all of the row, and adds what theme.qss keeps free around it afterwards.
    within.rect.setWidth(width - 2 * padding);
    const QSize size = QStyledItemDelegate::sizeHint(within, index);
    return {std::min(size.width(), width), size.height()};
  }

protected:
  // The first row is the scene as it was opened.
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.row() <= m_stack.index())
      return;
    option->font.setItalic(true);
    option->palette.setBrush(QPalette::Text, option->palette.placeholderText());
    option->palette.setBrush(QPalette::HighlightedText, option->palette.placeholderText());
  }

private:
  // What theme.qss keeps free on either side of a row, its border included.
  static constexpr int padding = 9;
  const QUndoStack& m_stack;
};

// The docks stand in the order in which they are added, which is that of the members.
template <class Panel>
Panel& dockedAtRight(WindowContext& context, const QString& title, const char* name,
                     SessionDocument::Panel inSessions) {
  auto* panel = new Panel(&context.window);
  context.docks.add({title, name, panel, Qt::RightDockWidgetArea, inSessions});
  return *panel;
}

// A ramp that ends above the brightest voxel would leave all of a picture dark.
TransferFunction ofMaximum(const Volume& volume, const Histogram& histogram) {
  if (!looksLikeHounsfield(volume))
    return fittedToValues(presetNamed(builtInPresets(), "MR maximum (MIP)"), volume, histogram)
        .transferFunction;
  TransferFunction ramp = presetNamed(builtInPresets(), "CT maximum (MIP)").transferFunction;
  const double black = ramp.points.front().value, white = ramp.points.back().value;
  const double highest = volume.range().highest;
  if (highest < white && highest > black)
    for (ControlPoint& point : ramp.points)
      point.value = black + (point.value - black) * (highest - black) / (white - black);
  return ramp;
}

} // namespace

ProjectionCurves::Kind ProjectionCurves::kindOf(Projection projection) {
  switch (projection) {
  case Projection::mip:
    return Kind::maximum;
  case Projection::minip:
    return Kind::minimum;
  case Projection::average:
    return Kind::average;
  case Projection::xray:
    return Kind::xray;
  case Projection::composite:
  case Projection::isosurface:
  case Projection::compositeIsosurface:
    break;
  }
  return Kind::tissue;
}

TransferFunction ProjectionCurves::ownCurve(const Scene& scene, Kind kind, const Histogram& histogram) {
  if (kind == Kind::maximum)
    return ofMaximum(*scene.volume, histogram);
  Preset preset;
  preset.modality = "CT";
  if (kind == Kind::tissue)
    preset = bestFitting(builtInPresets(), *scene.volume);
  else if (kind == Kind::xray)
    preset = presetNamed(builtInPresets(), "CT X-ray");
  else
    preset.transferFunction = kind == Kind::minimum ? minimumCurve() : averageCurve();
  return kind == Kind::tissue ? preset.transferFunction
                              : fittedToValues(preset, *scene.volume, histogram).transferFunction;
}

void ProjectionCurves::note(const Scene& scene) {
  if (m_volume != scene.volume)
    m_shown.clear();
  m_volume = scene.volume;
  if (scene.volume)
    m_shown[kindOf(scene.projection)] = scene.transferFunction;
}

Scene ProjectionCurves::changed(const Scene& scene, Projection projection, const Histogram& histogram) const {
  Scene result = withProjection(scene, projection, histogram);
  const Kind kind = kindOf(projection);
  if (!scene.volume || kind == kindOf(scene.projection))
    return result;
  const auto shown = m_volume == scene.volume ? m_shown.find(kind) : m_shown.end();
  result.transferFunction = shown != m_shown.end() ? shown->second : ownCurve(scene, kind, histogram);
  return result;
}

EarlierLook::EarlierLook(WindowContext& context)
    : QObject(&context.window), m_context(context),
      m_use(context.actions.add(
          QStringLiteral("earlierLook"),
          {.text = tr("Use the &look of the volume before"),
           .place = {Menu::preset, 1, 3},
           .shortcut = tr("Ctrl+L"),
           .toolTip = tr("Shows this volume with curve and light of the one that was open before it.")})) {
  m_use->setEnabled(false);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene& scene) { follow(scene); });
  connect(m_use, &QAction::triggered, this, &EarlierLook::use);
}

void EarlierLook::follow(const Scene& scene) {
  const std::shared_ptr<const Volume> before = m_volume.lock();
  // Where the voxels of one volume lie may change: orientation can be set by hand.
  const bool isSame = before && scene.volume && before->sharesVoxelsWith(*scene.volume);
  std::optional<Landmarks> landmarks;
  if (isSame) {
    landmarks = m_present->look.landmarks;
  } else {
    if (m_present)
      m_earlier = std::move(m_present);
    m_present.reset();
    if (scene.volume)
      landmarks = landmarksOf(m_context.document.histogram());
  }
  m_volume = scene.volume;
  if (scene.volume) {
    const Preset look = presetOf(scene, tr("Earlier look").toStdString());
    m_present = {withoutSmoothingOfSlices(look, scene.volume->grid()), looksLikeHounsfield(*scene.volume)};
    m_present->look.landmarks = landmarks;
  }
  m_use->setEnabled(m_earlier && scene.volume);
}

void EarlierLook::setEarlier(const std::optional<Shaped>& earlier) {
  m_earlier = earlier;
  m_use->setEnabled(m_earlier && m_context.session.scene().volume);
}

void EarlierLook::use() {
  const std::shared_ptr<const Volume>& volume = m_context.session.scene().volume;
  if (!m_earlier || !volume)
    return;
  Preset look = m_earlier->look;
  const bool haveOneScale = m_earlier->isHounsfield && looksLikeHounsfield(*volume);
  if (haveOneScale)
    look.landmarks.reset();
  const Scene before = m_context.session.scene();
  m_context.session.usePreset(fittedTo(look, m_context.document.histogram(), volume->grid()),
                              {nextGestureId(), tr("use the look of the volume before"), true});
  if (haveOneScale || m_context.session.scene() == before)
    return; // the volume had that look: there is no step of which anything could be said
  m_context.messages.show(
      MessageBar::Kind::note,
      tr("The look of the volume before was fitted to the values of this one: not both are in "
         "Hounsfield units."));
  m_context.messageGoesWithLastStep();
}

EmphasisController::EmphasisController(WindowContext& context, const CurveController& curves)
    : QObject(&context.window), m_context(context), m_curves(curves),
      m_light(new PointLight(*curves.panel().valueEditor()->canvas())) {
  connect(m_light, &PointLight::changed, this, &EmphasisController::show);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene&) { m_light->turnOff(); });
}

// The curve in the plot may be one that is previewed itself, and has other points than the session's.
void EmphasisController::show(std::optional<std::size_t> point) {
  Scene scene = m_context.session.scene();
  const TransferFunction& curve = m_curves.curveInHand();
  const bool isShown = scene.volume && point && *point < curve.points.size();
  emit lit(isShown ? point : std::nullopt, isShown ? m_curves.labelInHand() : std::nullopt);
  QString what;
  if (isShown) {
    what = tr("in green what the point at %1 governs")
               .arg(readingText(curve.points[*point].value, *scene.volume));
    scene = m_curves.withCurveInHand(withPointEmphasised(curve, *point));
  }
  m_context.view.setScene(scene); // until the session's own ends it
  m_context.view.setPreview(what.toStdString());
}

Panels::Panels(WindowContext& context)
    : QObject(&context.window), m_context(context), m_presets(context),
      m_properties(dockedAtRight<PropertiesPanel>(context, tr("Prop&erties"), "shadingDock",
                                                  SessionDocument::Panel::properties)),
      m_effects(dockedAtRight<EffectsPanel>(context, tr("Effec&ts"), "effectsDock",
                                            SessionDocument::Panel::effects)),
      m_accuracy(context), m_ray(context), m_curves(context), m_cropBox(context, *m_properties.cropSection()),
      m_suggestions(context), m_emphasis(context, m_curves), m_earlier(context), m_looks(context, m_presets),
      m_thumbnails(context, m_presets) {
  addHistory();
  connectProperties();
  addEffects();
  connect(&m_presets, &PresetController::previewed, this, &Panels::showPreview);
  m_presets.setShownAs([this](const Preset& preset) {
    return m_curves.labelInHand() ? std::optional(m_curves.withCurveInHand(preset.transferFunction))
                                  : std::nullopt;
  });
  connect(&m_suggestions, &SuggestionController::previewed, this,
          [this](const Scene& scene) { showPreview(scene, {}); });
  context.followers.add(SceneFollowers::Stage::view, [this](const Scene& scene) { showScene(scene); });
  m_presets.refresh();
}

void Panels::addHistory() {
  auto* history = new QUndoView(&m_context.session.undoStack(), &m_context.window);
  history->setEmptyLabel(tr("As opened"));
  history->setAccessibleName(tr("History"));
  history->setSpacing(2);
  history->setItemDelegate(new HistoryDelegate(m_context.session.undoStack(), history));
  history->setWordWrap(true);
  history->setResizeMode(QListView::Adjust);
  history->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // Where it lies on top the presets must not become narrower than they can be.
  history->setMinimumWidth(m_presets.browser().minimumSizeHint().width());
  m_context.docks.add({tr("&History"), "historyDock", history, Qt::LeftDockWidgetArea});
  QUndoStack& stack = m_context.session.undoStack();
  QAction* undo = m_context.actions.add(
      stack.createUndoAction(&m_context.window, tr("Undo")), QStringLiteral("undo"),
      {.text = {}, .place = {Menu::edit, 1, 1}, .icon = QStringLiteral("undo"), .tool = {2, 1}});
  QAction* redo = m_context.actions.add(
      stack.createRedoAction(&m_context.window, tr("Redo")), QStringLiteral("redo"),
      {.text = {}, .place = {Menu::edit, 1, 2}, .icon = QStringLiteral("redo"), .tool = {2, 2}});
  undo->setShortcuts(QKeySequence::Undo);
  redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
}

void Panels::connectProperties() {
  const PropertiesPanel* panel = &m_properties;
  Session* session = &m_context.session;
  connect(panel, &PropertiesPanel::shadingEdited, session, &Session::setShading);
  connect(panel, &PropertiesPanel::qualityEdited, session, &Session::setQuality);
  connect(panel, &PropertiesPanel::isovalueEdited, session, &Session::setIsovalue);
  connect(panel, &PropertiesPanel::fogEdited, session, &Session::setFog);
  connect(panel, &PropertiesPanel::cropEdited, session, &Session::setCrop);
  connect(panel->labelSection(), &LabelSection::opened, this, [this] {
    if (!m_context.docks.isFolded(Qt::RightDockWidgetArea)) // or the picture has its room
      m_context.docks.show(SessionDocument::Panel::properties);
  });
  connect(panel, &PropertiesPanel::projectionEdited, this,
          [this](Projection projection, const Gesture& gesture) {
            m_context.session.edit(
                m_projections.changed(m_context.session.scene(), projection, m_context.document.histogram()),
                gesture);
          });
}

void Panels::addEffects() {
  connect(&m_context.view, &CompareView::told, this, [this](const ViewNews& news) {
    m_effects.setRows(news.effects, news.effectsOf);
    m_effects.setSwitchable(switchableEffects(news.effects));
    m_effects.setTimes(news.times);
  });
  connect(&m_effects, &EffectsPanel::effectSwitched, this, &Panels::switchEffect);
  connect(&m_effects, &EffectsPanel::measureRequested, this, [this] { m_context.view.measureEffects(); });
  connect(&m_effects, &EffectsPanel::cancelRequested, this, [this] { m_context.view.measureEffects(false); });
}

// What is off may be so because nothing in the picture calls for it: only what was switched off here is
// offered.
std::set<std::string> Panels::switchableEffects(const std::vector<EffectRow>& rows) const {
  std::set<std::string> switchable;
  const Scene& scene = m_context.session.scene();
  for (const EffectRow& row : rows)
    if (scene.volume &&
        (row.isOn ? withoutEffect(scene, row.name).has_value() : m_switchedOff.contains(row.name)))
      switchable.insert(row.name);
  return switchable;
}

void Panels::switchEffect(const QString& effect, bool isOn) {
  const std::string name = effect.toStdString();
  const Scene& scene = m_context.session.scene();
  const auto before = m_switchedOff.find(name);
  std::optional<Scene> next;
  if (!isOn)
    next = withoutEffect(scene, name);
  else if (before != m_switchedOff.end())
    next = withEffect(scene, name, before->second);
  if (!next)
    return;
  if (!isOn) {
    Scene kept = scene;
    kept.volume.reset(); // its numbers are enough
    kept.keep = {};
    m_switchedOff[name] = kept;
  }
  m_context.session.edit(*next, switchGesture(m_effects.titleOf(effect), isOn));
}

void Panels::showScene(const Scene& scene) {
  m_projections.note(scene);
  m_properties.setScene(scene);
  m_presets.markShown();
  m_presets.browser().setVolumeOpen(scene.volume != nullptr);
}

// The session's own scene ends it.
void Panels::showPreview(const Scene& scene, const std::string& preset) {
  m_context.view.setScene(scene);
  m_context.view.setPreview(preset);
  m_curves.showScene(scene);
}

void Panels::showVolume(const std::shared_ptr<const Volume>& volume, const Histogram& histogram) {
  m_curves.showVolume(volume, histogram);
  m_cropBox.setShown(false); // the frame was around another volume
  m_switchedOff.clear();
  if (volume)
    m_properties.foldUnused();
}

void Panels::takeLabel(std::size_t place) {
  const Region& keep = m_context.session.scene().keep;
  m_context.docks.show(SessionDocument::Panel::properties);
  m_properties.labelSection()->select(place);
  m_curves.takeInHand(lookOfLabel(keep, place) > 0 ? std::optional(place) : std::nullopt);
}

void Panels::showSavedPaths() {
  m_context.docks.show(SessionDocument::Panel::properties);
  m_properties.showSavedPaths();
}

void Panels::describe(SessionDocument& session) const {
  session.panel = m_context.docks.panel();
  session.cropBoxIsShown = m_cropBox.isShown();
  session.gradientCurveIsShown = m_curves.panel().gradientIsShown();
  if (const auto label = m_curves.labelInHand())
    session.labelInHand = static_cast<int>(*label);
}

void Panels::restore(const SessionDocument& session) {
  m_cropBox.setShown(session.cropBoxIsShown);
  m_curves.panel().showGradient(session.gradientCurveIsShown);
  m_curves.takeInHand(session.labelInHand ? std::optional(static_cast<std::size_t>(*session.labelInHand))
                                          : std::nullopt);
  m_context.docks.show(session.panel);
}

Panels::Memory Panels::memory() const {
  return {m_switchedOff, m_projections, m_earlier.earlier(), m_accuracy.memory(), m_properties.folded()};
}

void Panels::takeOver(const Memory& memory) {
  m_switchedOff = memory.switchedOff;
  m_projections = memory.projections;
  m_earlier.setEarlier(memory.earlier);
  m_accuracy.takeOver(memory.accuracy);
  m_properties.setFolded(memory.foldedProperties);
}

} // namespace limn
