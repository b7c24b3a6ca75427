// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/volume/OrientationDesk.h"

#include "app/document/Session.h"
#include "app/window/volume/OrientationDialog.h"
#include "scene/view/Camera.h"
#include "scene/volume/Orientation.h"

#include <QAction>
#include <QActionGroup>
#include <QWidget>

namespace limn {
namespace {

// Where a standard view stands of voxels that tell no sides: "From the first row".
QString voxelViewName(const Grid& grid, StandardView view) {
  const Camera camera = standardView({}, grid, view);
  const glm::dvec3 from = glm::transpose(grid.direction) * (camera.position - camera.target);
  const glm::dvec3 size = glm::abs(from);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const bool isLast = from[axis] > 0.0;
  switch (axis) {
  case 0:
    return isLast ? OrientationDesk::tr("From the last column")
                  : OrientationDesk::tr("From the first column");
  case 1:
    return isLast ? OrientationDesk::tr("From the last row") : OrientationDesk::tr("From the first row");
  default:
    return isLast ? OrientationDesk::tr("From the last slice") : OrientationDesk::tr("From the first slice");
  }
}

} // namespace

OrientationDesk::OrientationDesk(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
  for (const QAction* action : m_parts.views.actions())
    m_viewNames << action->text();
  m_parts.setOrientation.setEnabled(false);
  connect(&m_parts.setOrientation, &QAction::triggered, this, &OrientationDesk::ask);
  connect(&m_parts.session, &Session::sceneChanged, this, &OrientationDesk::showScene);
}

void OrientationDesk::showScene(const Scene& scene) {
  if (scene.volume == m_volume)
    return;
  m_volume = scene.volume;
  const bool isKnown = !m_volume || m_volume->info().orientationKnown;
  const bool isByHand = m_volume && !m_volume->info().orientationByHand.empty();
  m_parts.setOrientation.setEnabled(!isKnown || isByHand);
  for (qsizetype i = 0; i < m_viewNames.size(); ++i) {
    QAction* action = m_parts.views.actions()[i];
    action->setText(isKnown
                        ? m_viewNames[i]
                        : voxelViewName(m_volume->grid(), static_cast<StandardView>(action->data().toInt())));
  }
  if (m_dialog && !m_parts.setOrientation.isEnabled())
    m_dialog->close();
  else if (m_dialog)
    m_dialog->setLetters(axisLettersOf(m_volume->grid()));
}

void OrientationDesk::ask() {
  if (!m_volume || !m_parts.setOrientation.isEnabled())
    return;
  if (!m_dialog) {
    m_dialog = new OrientationDialog(axisLettersOf(m_volume->grid()), &m_parts.window);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_dialog, &OrientationDialog::lettersChosen, this, &OrientationDesk::orient);
    connect(m_dialog, &QDialog::rejected, this, &OrientationDesk::takeBack);
    m_asFound = m_volume;
    m_answered.reset();
  }
  m_dialog->show();
  m_dialog->raise();
}

void OrientationDesk::orient(const std::string& letters) {
  if (!m_volume || m_volume->info().orientationByHand == letters)
    return;
  Scene next = m_parts.session.scene();
  next.volume = m_answered = orientedByHand(*m_volume, letters);
  m_parts.session.edit(next,
                       {nextGestureId(), tr("set orientation %1").arg(QString::fromStdString(letters))});
}

// Whatever was shown on trial goes, unless something else has taken its place.
void OrientationDesk::takeBack() {
  if (!m_answered || m_parts.session.scene().volume != m_answered)
    return;
  Scene next = m_parts.session.scene();
  next.volume = m_asFound;
  m_parts.session.edit(next, {nextGestureId(), tr("take back the orientation")});
}

} // namespace limn
