// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/Panels.h"

#include "app/window/WindowContext.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/EffectsPanel.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/CompareView.h"

#include <QStyledItemDelegate>
#include <QUndoView>

namespace limn {
namespace {

// Edits are named as undo says them, "move point"; a list of them begins each with a capital.
class CapitalDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QString displayText(const QVariant& value, const QLocale& locale) const override {
    QString text = QStyledItemDelegate::displayText(value, locale);
    if (!text.isEmpty())
      text[0] = text[0].toUpper();
    return text;
  }
};

// The docks stand in the order in which they are added, which is that of the members.
template <class Panel>
Panel& dockedAtRight(WindowContext& context, const QString& title, const char* name,
                     SessionDocument::Panel inSessions) {
  auto* panel = new Panel(&context.window);
  context.docks.add({title, name, panel, Qt::RightDockWidgetArea, inSessions});
  return *panel;
}

} // namespace

Panels::Panels(WindowContext& context)
    : QObject(&context.window), m_context(context), m_presets(context),
      m_properties(dockedAtRight<PropertiesPanel>(context, tr("Prop&erties"), "shadingDock",
                                                  SessionDocument::Panel::properties)),
      m_effects(dockedAtRight<EffectsPanel>(context, tr("Effec&ts"), "effectsDock",
                                            SessionDocument::Panel::effects)),
      m_accuracy(context), m_ray(context), m_curves(context), m_cropBox(context, *m_properties.cropSection()),
      m_suggestions(context), m_emphasis(context, *m_curves.panel().valueEditor()->canvas()),
      m_earlier(context), m_looks(context, m_presets), m_thumbnails(context, m_presets) {
  addHistory();
  connectProperties();
  addEffects();
  connect(&m_presets, &PresetController::previewed, this, &Panels::showPreview);
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
  history->setItemDelegate(new CapitalDelegate(history));
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
  connect(panel->labelSection(), &LabelSection::keepEdited, session, &Session::setKeep);
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
    m_effects.setTimes(news.times);
  });
  connect(&m_effects, &EffectsPanel::measureRequested, &m_context.view, &CompareView::measureEffects);
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
  if (volume)
    m_properties.foldUnused();
}

void Panels::describe(SessionDocument& session) const {
  session.panel = m_context.docks.panel();
  session.cropBoxIsShown = m_cropBox.isShown();
  session.gradientCurveIsShown = m_curves.panel().gradientIsShown();
}

void Panels::restore(const SessionDocument& session) {
  m_cropBox.setShown(session.cropBoxIsShown);
  m_curves.panel().showGradient(session.gradientCurveIsShown);
  m_context.docks.show(session.panel);
}

} // namespace limn
