// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/CameraFit.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGuiApplication>
#include <QMetaObject>

#include <utility>

namespace limn {

void CameraFit::setScene(const Scene& scene) {
  const bool isSameVolume = scene.volume == m_scene.volume;
  const bool isCutAnew =
      isSameVolume && scene.volume && (scene.crop != m_scene.crop || scene.keep != m_scene.keep);
  const bool wasFramed = isCutAnew && (m_isDue || isFramedNow());
  const bool isSameBox = isSameVolume && !isCutAnew && scene.transferFunction == m_scene.transferFunction &&
                         scene.projection == m_scene.projection && scene.isovalue == m_scene.isovalue;
  m_scene = scene;
  if (!isSameBox)
    m_box.reset();
  if (!isSameVolume) {
    m_isDue = false;
    m_settledAspect.reset();
    if (scene.volume && isFramedNow())
      settle();
  }
  if (!wasFramed)
    return;
  m_isDue = true;
  // A handle must not run away from the pointer that holds it.
  if (QGuiApplication::mouseButtons() == Qt::NoButton)
    QMetaObject::invokeMethod(this, &CameraFit::frameAnew, Qt::QueuedConnection);
  else
    QCoreApplication::instance()->installEventFilter(this);
}

void CameraFit::setAspect(double aspect) {
  m_aspect = aspect;
  if (!m_scene.volume || !m_settledAspect || *m_settledAspect == aspect)
    return;
  const double before = *m_settledAspect;
  m_settledAspect = aspect;
  emit cameraEdited(refitted(m_scene.camera, m_scene.volume->grid(), box(), before, aspect));
}

void CameraFit::settle() {
  m_settledAspect = m_aspect;
}

const IndexBox& CameraFit::box() {
  if (!m_box)
    m_box = visibleBox(m_scene);
  return *m_box;
}

bool CameraFit::isFramedNow() {
  return isFramed(m_scene.camera, m_scene.volume->grid(), box(), m_aspect);
}

void CameraFit::frameAnew() {
  if (!std::exchange(m_isDue, false) || !m_scene.volume)
    return;
  emit cameraEdited(framed(m_scene.camera, m_scene.volume->grid(), box(), m_aspect));
}

bool CameraFit::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonRelease && QGuiApplication::mouseButtons() == Qt::NoButton) {
    QCoreApplication::instance()->removeEventFilter(this);
    // Behind what the release itself does.
    QMetaObject::invokeMethod(this, &CameraFit::frameAnew, Qt::QueuedConnection);
  }
  return QObject::eventFilter(watched, event);
}

} // namespace limn
