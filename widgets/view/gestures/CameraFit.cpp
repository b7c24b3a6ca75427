// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/CameraFit.h"

namespace limn {

void CameraFit::setScene(const Scene& scene) {
  const bool isSameVolume = scene.volume == m_scene.volume;
  const bool sameIsVisible = isSameVolume && scene.crop == m_scene.crop && scene.keep == m_scene.keep &&
                             scene.transferFunction == m_scene.transferFunction &&
                             scene.projection == m_scene.projection && scene.isovalue == m_scene.isovalue;
  m_scene = scene;
  if (!sameIsVisible)
    m_visible.reset();
  if (isSameVolume)
    return;
  m_settledAspect.reset();
  if (scene.volume && isFramed(scene.camera, scene.volume->grid(), visible(), m_aspect))
    settle();
}

void CameraFit::setAspect(double aspect) {
  m_aspect = aspect;
  if (!m_scene.volume || !m_settledAspect || *m_settledAspect == aspect)
    return;
  const double before = *m_settledAspect;
  m_settledAspect = aspect;
  emit cameraEdited(refitted(m_scene.camera, m_scene.volume->grid(), visible(), before, aspect));
}

void CameraFit::settle() {
  m_settledAspect = m_aspect;
}

const VisibleVoxels& CameraFit::visible() {
  if (!m_visible)
    m_visible = visibleVoxels(m_scene);
  return *m_visible;
}

} // namespace limn
