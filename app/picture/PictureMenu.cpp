// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/PictureMenu.h"

#include "app/picture/CameraController.h"
#include "app/window/WindowContext.h"
#include "planes/PlaneGrid.h"
#include "scene/regions/BodyAndLabels.h"
#include "scene/regions/LabelAt.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/Overlay.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>

namespace limn {
namespace {

QAction* addEntry(QMenu& menu, const char* name, const QString& text, const QString& tip, bool isEnabled) {
  QAction* entry = menu.addAction(text);
  entry->setObjectName(QLatin1String(name));
  entry->setToolTip(tip);
  entry->setEnabled(isEnabled);
  return entry;
}

} // namespace

PictureMenu::PictureMenu(WindowContext& context) : QObject(&context.window), m_context(context) {
  connect(&context.view.input(), &ViewInput::menuRequested, this, &PictureMenu::open);
  connect(&context.planes, &PlaneDeck::menuRequested, this, &PictureMenu::openOnSlice);
}

QMenu* PictureMenu::newMenu(const char* name) {
  auto* menu = new QMenu(&m_context.view);
  menu->setObjectName(QLatin1String(name));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  return menu;
}

void PictureMenu::open(const std::optional<Ray>& ray, int side, const QPoint& at) {
  QMenu* menu = newMenu("pictureMenu");
  addTurns(*menu, ray, side);
  menu->addSeparator();
  const std::optional<Probe> probe =
      ray ? probeAlong(m_context.view.sceneOfSide(side), m_context.view.input().scaleOfSide(side), *ray)
          : std::nullopt;
  addPlace(*menu, probe);
  menu->addSeparator();
  addPiece(*menu, ray, side, probe.has_value());
  addLabel(*menu, probe);
  menu->addSeparator();
  addViews(*menu);
  menu->popup(m_context.view.mapToGlobal(at));
}

void PictureMenu::openOnSlice(PatientPlane plane, const glm::dvec3& worldMm, const QPoint& globalAt) {
  const Volume& volume = *m_context.session.scene().volume;
  const glm::dvec3 index = worldToIndex(volume.grid(), worldMm);
  const std::optional<Probe> probe = isInside(volume.grid(), worldMm)
                                         ? std::optional(Probe{valueAt(volume, index), worldMm, index})
                                         : std::nullopt;
  QMenu* menu = newMenu("sliceMenu");
  addCopying(*menu, probe);
  addSlice(*menu, plane);
  menu->addSeparator();
  const QAction* pick =
      addEntry(*menu, "pickPiece", tr("Pick this piece"),
               tr("Lights up what hangs together here, to be hidden or kept alone."), probe.has_value());
  connect(pick, &QAction::triggered, this, [this, worldMm] { emit pieceInSliceChosen(worldMm); });
  addLabel(*menu, probe);
  menu->popup(globalAt);
}

void PictureMenu::addSlice(QMenu& menu, PatientPlane plane) {
  const QAction* copy = addEntry(menu, "copySlice", tr("Copy this slice"),
                                 tr("Puts the slice on the clipboard as it is seen, with sides, scale and "
                                    "measurements, without the crosshair."),
                                 true);
  const QAction* save = addEntry(menu, "saveSlice", tr("Save this slice…"),
                                 tr("Saves the same as a picture, as large as you like."), true);
  connect(copy, &QAction::triggered, this, [this, plane] { emit sliceCopyChosen(plane); });
  connect(save, &QAction::triggered, this, [this, plane] { emit sliceSaveChosen(plane); });
}

void PictureMenu::addTurns(QMenu& menu, const std::optional<Ray>& ray, int side) {
  const TurnCentre centre = ray ? turnCentreAlong(m_context.view, *ray, side) : TurnCentre{{}, noPlaceText()};
  const QAction* about =
      addEntry(menu, "turnAbout", tr("Turn about this"),
               centre.placeMm ? tr("Turns go about what is seen here until the camera is reset (R). "
                                   "Shift+middle click does the same.")
                              : centre.reason,
               centre.placeMm.has_value());
  const bool hasCentre = m_context.view.turnsAbout().has_value();
  const QAction* freely = addEntry(menu, "turnAboutMiddle", tr("Turn about the middle"),
                                   hasCentre ? tr("Turns go about the middle of the view again.")
                                             : tr("Turns go about the middle of the view already."),
                                   hasCentre);
  connect(about, &QAction::triggered, this, [this, centre] { emit turnAboutChosen(centre.placeMm); });
  connect(freely, &QAction::triggered, this, [this] { emit turnAboutChosen(std::nullopt); });
}

void PictureMenu::addCopying(QMenu& menu, const std::optional<Probe>& probe) {
  const Scene& scene = m_context.view.scene();
  const QString value = probe && scene.volume ? readingText(probe->value, *scene.volume) : QString();
  const QAction* copy = addEntry(
      menu, "copyValue", probe ? tr("Copy value: %1").arg(value) : tr("Copy value"),
      probe ? tr("Puts the value that is seen here on the clipboard, with its unit.") : noPlaceText(),
      probe.has_value());
  connect(copy, &QAction::triggered, this, [value] { QApplication::clipboard()->setText(value); });
}

void PictureMenu::addPlace(QMenu& menu, const std::optional<Probe>& probe) {
  addCopying(menu, probe);
  const bool hasSlices = m_context.session.planes().layout != PlaneLayout::pictureOnly;
  const QAction* go =
      addEntry(menu, "goInSlices", tr("Go there in slices"),
               !hasSlices ? tr("There are no slices beside the picture; View ▸ Slices shows them.")
               : probe    ? tr("Moves the crosshair to what is seen here. Shift+click does the same.")
                          : noPlaceText(),
               probe && hasSlices);
  menu.addActions({&m_context.actions.find("cutOpen"), &m_context.actions.find("cutOpenCorner")});
  connect(go, &QAction::triggered, this, [this, probe] { emit placeChosen(probe->positionMm); });
}

void PictureMenu::addPiece(QMenu& menu, const std::optional<Ray>& ray, int side, bool isSeen) {
  const QAction* pick = addEntry(
      menu, "pickPiece", tr("Pick this piece"),
      isSeen ? tr("Lights up what hangs together here, to be hidden or kept alone.") : noPlaceText(), isSeen);
  connect(pick, &QAction::triggered, this, [this, ray, side] { emit pieceChosen(*ray, side); });
}

void PictureMenu::addLabel(QMenu& menu, const std::optional<Probe>& probe) {
  const Region& keep = m_context.session.scene().keep;
  std::optional<std::size_t> place = probe ? voxelLabelAt(keep, probe->index) : std::nullopt;
  if (place == tableLabel(keep))
    place.reset();
  QString name = place ? QString::fromStdString(keep.labels->labels()[*place].name) : QString();
  name.replace(u'&', QStringLiteral("&&")); // or it would be a letter of the menu's
  const QAction* take = addEntry(
      menu, "takeLabel", place ? tr("Take %1 in hand").arg(name) : tr("Take this label in hand"),
      keep.kind != Region::Kind::labels ? tr("No segmentation is open; File ▸ Open labels… opens one.")
      : !place                          ? noPlaceText()
      : lookOfLabel(keep, *place) > 0   ? tr("Selects it in the list of labels, and shows its curve.")
                                        : tr("Selects it in the list of labels."),
      place.has_value());
  connect(take, &QAction::triggered, this, [this, place] { emit labelChosen(*place); });
}

void PictureMenu::addViews(QMenu& menu) {
  const ActionList& actions = m_context.actions;
  QMenu* from = menu.addMenu(tr("Look from"));
  from->addActions(actions.find("view-anterior").actionGroup()->actions());
  from->addSeparator();
  from->addActions(actions.find("keepView").actionGroup()->actions());
  menu.addActions({&actions.find("resetCamera"), &actions.find("cameraBack")});
}

} // namespace limn
