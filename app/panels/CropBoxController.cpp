// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/CropBoxController.h"

#include "app/window/WindowContext.h"
#include "scene/framing/VisibleVoxels.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/properties/CropSection.h"
#include "widgets/view/CompareView.h"

#include <QApplication>
#include <QUndoStack>

namespace limn {

CropBoxController::CropBoxController(WindowContext& context, const CropSection& section)
    : m_context(context), m_section(section),
      m_unseen(context, [this](const Scene& s) { return isBegun(s); }),
      m_action(context.actions.add(
          QStringLiteral("cropBox"),
          {.text = tr("&Crop box"),
           .place = {Menu::view, 2, 7},
           .shortcut = Qt::Key_B,
           .toolTip = tr("Shows a box with handles in the picture; what is outside is cut away. (B)"),
           .icon = QStringLiteral("crop-box"),
           .tool = {6, 1},
           .isCheckable = true,
           .needsVolume = true})) {
  context.actions.addToolMenu(QStringLiteral("cropBox"), {QStringLiteral("turnCropBox")});
  // A letter belongs to whatever has the focus: this one to picture and slices.
  m_action->setShortcutContext(Qt::WidgetShortcut);
  context.view.addAction(m_action);
  for (const PatientPlane plane : patientPlanes)
    context.planes.view(plane)->addAction(m_action);
  connect(m_action, &QAction::toggled, this, [this](bool isOn) {
    m_hidTurned = !isOn && m_context.view.order().comparison.turnedBox;
    m_isEdited = m_isEdited && isOn; // who puts it away wants to see it no more, wherever it came from
    show();
  });
  connect(m_action, &QAction::triggered, this, &CropBoxController::begin);
  connect(&section, &FoldingSection::foldedByUser, this, [this](bool folded) {
    m_isEdited = !folded;
    show();
  });
  connect(&context.session.undoStack(), &QUndoStack::indexChanged, this, &CropBoxController::followUndo);
  connect(qApp, &QApplication::focusChanged, this,
          [this](const QWidget*, const QWidget* now) { followFocus(now); });
}

// Air and table would lie between its handles and what is seen.
void CropBoxController::begin(bool isShown) {
  const Scene& scene = m_context.session.scene();
  if (m_hidTurned || m_context.view.order().comparison.turnedBox)
    return m_begun.reset(); // what shows, or was put away, is another box
  const CropBox around = isShown ? boxAroundBody(scene) : CropBox{};
  if (isShown && scene.crop == CropBox{} && around != CropBox{}) {
    m_begun = Begun{scene.volume, around, nextGestureId()};
    m_context.view.setCropHidesNothing(true); // of the body alone; what lies beside it is hidden already
    m_context.session.setCrop(around, {m_begun->gesture, tr("crop box around the body")});
    m_begun->step.emplace(m_context.session.undoStack());
  } else if (!isShown && isBegun(scene)) {
    // The same gesture: undo sees that nothing is left of it.
    m_context.session.setCrop({}, {m_begun->gesture, tr("crop box around the body")});
  }
  if (!isShown)
    m_begun.reset();
}

bool CropBoxController::isBegun(const Scene& scene) const {
  return m_begun && m_begun->volume == scene.volume && m_begun->crop == scene.crop;
}

// What was done instead of redoing it leaves the box away.
void CropBoxController::followUndo() {
  if (!m_begun || !m_begun->step)
    return;
  m_begun->step->follow();
  if (m_begun->step->isDone() != m_begun->isUndone)
    return;
  const bool comesBack = m_begun->isUndone;
  const Scene& scene = m_context.session.scene();
  const bool isTurned = m_context.view.order().comparison.turnedBox.has_value(); // another box
  if (scene.volume != m_begun->volume || isTurned || (comesBack && !isBegun(scene)))
    return m_begun.reset();
  if (!comesBack && isBegun(scene))
    return; // another step was undone
  m_begun->isUndone = !comesBack;
  m_action->setChecked(comesBack);
}

bool CropBoxController::isShown() const {
  return m_action->isChecked();
}

void CropBoxController::setShown(bool isShown) {
  if (!isShown)
    m_begun.reset(); // keeps its volume
  m_action->setChecked(isShown);
}

void CropBoxController::show() {
  m_context.view.setCropBoxVisible(m_action->isChecked() || (m_isEdited && !m_section.isFolded()));
}

void CropBoxController::followFocus(const QWidget* now) {
  if (!now)
    return; // another program's turn
  const bool isInSection = m_section.isAncestorOf(now) && !m_section.isFolded();
  m_isEdited = isInSection || (m_isEdited && now == &m_context.view);
  show();
}

} // namespace limn
