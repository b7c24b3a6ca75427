// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/picture/ComparisonDesk.h"

#include "app/actions/Actions.h"
#include "app/document/OpenDocument.h"
#include "widgets/view/CompareView.h"

namespace limn {
namespace {

// What the session file calls it, whatever the language.
const std::string snapshotName = "(before)";

// Where they lie may differ: orientation can be set by hand.
bool haveSameVoxels(const Volume* a, const Volume* b) {
  return a == b || (a && b && a->sharesVoxelsWith(*b));
}

} // namespace

ComparisonDesk::ComparisonDesk(Session& session, const OpenDocument& document, CompareView& view,
                               const Actions& actions, QObject* parent)
    : QObject(parent), m_session(session), m_document(document), m_view(view), m_actions(actions) {
  connect(actions.layouts, &QActionGroup::triggered, this,
          [this](QAction* chosen) { setLayout(static_cast<CompareLayout>(chosen->data().toInt())); });
  for (int side = 0; side < 2; ++side)
    connect(actions.models[static_cast<std::size_t>(side)], &QActionGroup::triggered, this,
            [this, side](QAction* chosen) {
              setSideModel(side, static_cast<ShadingModel>(chosen->data().toInt()));
            });
  connect(&view, &CompareView::modelChosen, this, &ComparisonDesk::setSideModel);
  connect(actions.takeSnapshot, &QAction::triggered, this, &ComparisonDesk::takeSnapshot);
  connect(actions.compareSnapshot, &QAction::triggered, this,
          [this](bool isChosen) { isChosen ? compareWith(*m_snapshot) : compareModels(); });
  connect(actions.compareModels, &QAction::triggered, this, &ComparisonDesk::compareModels);
}

void ComparisonDesk::setLayout(CompareLayout layout) {
  m_beforeImage.reset();
  m_view.setCompareLayout(layout);
  checkOnly(*m_actions.layouts, static_cast<int>(layout));
  show();
}

void ComparisonDesk::setSideModel(int side, ShadingModel model) {
  const bool isSingle = m_view.compareLayout() == CompareLayout::single;
  if (isSingle || (m_look && side == 1)) {
    Shading shading = m_session.scene().shading;
    shading.model = model;
    m_session.setShading(shading, {nextGestureId(), tr("change model")});
    return;
  }
  if (m_look)
    m_look->shading->model = model;
  else
    (side == 0 ? m_left : m_right) = model;
  show();
}

void ComparisonDesk::compareWith(const Preset& look) {
  m_look = look;
  if (!m_look->shading)
    m_look->shading = m_session.scene().shading;
  if (m_view.compareLayout() == CompareLayout::single)
    setLayout(CompareLayout::sideBySide);
  else
    show();
}

void ComparisonDesk::compareModels() {
  m_look.reset();
  show();
}

void ComparisonDesk::takeSnapshot() {
  const bool isCompared = m_look && m_look->name == snapshotName;
  m_snapshot = presetOf(m_session.scene(), snapshotName);
  if (isCompared)
    m_look = m_snapshot;
  show();
}

// The scene's own look is named after its preset; beside "before" it is what became of it.
std::optional<ComparedLook> ComparisonDesk::comparedLook() const {
  if (!m_look)
    return std::nullopt;
  const auto text = [](const QString& name) { return name.toStdString(); };
  if (m_look->name == snapshotName)
    return ComparedLook{*m_look, {text(tr("Before")), text(tr("Now"))}};
  const OpenDocument::PresetInUse own = m_document.presetInUse();
  const QString name = QString::fromStdString(own.name);
  return ComparedLook{*m_look,
                      {m_look->name, text(own.name.empty() ? tr("Now")
                                          : own.isModified ? tr("%1, modified", "a preset").arg(name)
                                                           : name)}};
}

void ComparisonDesk::showOpened() {
  const Scene& scene = m_session.scene();
  const bool isImage =
      scene.volume && imageNormalAxis(scene.volume->grid()) && scene.shading.model == ShadingModel::none;
  if (isImage && !m_beforeImage) {
    const CompareLayout before = m_view.compareLayout();
    setLayout(CompareLayout::single);
    m_beforeImage = before;
  } else if (!isImage && m_beforeImage) {
    setLayout(*m_beforeImage);
  }
}

void ComparisonDesk::show() {
  const Scene& scene = m_session.scene();
  if (!haveSameVoxels(m_volume.get(), scene.volume.get())) {
    m_snapshot.reset();
    m_look.reset();
  }
  m_volume = scene.volume;
  const bool isSingle = m_view.compareLayout() == CompareLayout::single;
  m_view.setSides({m_left, m_right}, comparedLook());
  m_actions.compareSnapshot->setEnabled(m_snapshot.has_value());
  m_actions.compareSnapshot->setChecked(m_look && m_look->name == snapshotName && !isSingle);
  m_actions.compareModels->setEnabled(m_look && !isSingle);
  const ShadingModel own = scene.shading.model;
  emit modelsShown(isSingle ? std::vector{own}
                   : m_look ? std::vector{m_look->shading->model, own}
                            : std::vector{m_left, m_right});
  emit shown();
}

void ComparisonDesk::describe(SessionDocument& session) const {
  session.layout = m_view.compareLayout();
  session.leftModel = m_left;
  session.rightModel = m_right;
  session.wipe = m_view.wipePosition();
  session.snapshot = m_snapshot;
  session.comparedLook = m_look;
}

void ComparisonDesk::restore(const SessionDocument& session) {
  m_left = session.leftModel;
  m_right = session.rightModel;
  m_snapshot = session.snapshot;
  m_look = session.comparedLook;
  if (m_look && !m_look->shading)
    m_look->shading = m_session.scene().shading;
  m_view.setWipePosition(session.wipe);
  setLayout(session.layout);
}

} // namespace limn
