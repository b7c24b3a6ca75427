// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "scene/PresetFit.h"
#include "widgets/scene/ProjectionSection.h"
#include "widgets/shading/ShadingPanel.h"

namespace limn {

template <class Change>
void MainWindow::editScene(const Gesture& gesture, Change&& change) {
  Scene next = m_session.scene();
  change(next);
  m_session.edit(next, gesture);
}

void MainWindow::connectSceneSections() {
  connect(m_shading, &ShadingPanel::projectionEdited, this, &MainWindow::setProjection);
  connect(m_shading, &ShadingPanel::isovalueEdited, this, [this](double isovalue, const Gesture& gesture) {
    editScene(gesture, [&](Scene& scene) { scene.isovalue = isovalue; });
  });
  connect(m_shading, &ShadingPanel::fogEdited, this, [this](const Fog& fog, const Gesture& gesture) {
    editScene(gesture, [&](Scene& scene) { scene.fog = fog; });
  });
  connect(m_shading, &ShadingPanel::cropEdited, this, [this](const CropBox& crop, const Gesture& gesture) {
    editScene(gesture, [&](Scene& scene) { scene.crop = crop; });
  });
}

void MainWindow::setProjection(Projection projection, const Gesture& gesture) {
  editScene(gesture, [&](Scene& scene) {
    scene.projection = projection;
    if (!usesIsovalue(projection) || !scene.volume)
      return;
    // A value that no voxel has would show nothing: begin between background and object.
    const ValueRange& range = scene.volume->range();
    if (scene.isovalue <= range.lowest || scene.isovalue >= range.highest)
      scene.isovalue = objectThreshold(m_histogram);
  });
}

} // namespace limn
