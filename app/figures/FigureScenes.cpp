// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figures/FigureScenes.h"

#include "planes/GreyWindows.h"

namespace limn {

FigurePanel panelOf(const LoadedFigure::Panel& loaded) {
  FigurePanel panel;
  if (loaded.plane)
    panel = planePanel(loaded.scene.scene, *loaded.plane, loaded.planes);
  panel.scene = loaded.scene.scene;
  panel.name = QString::fromStdString(loaded.name);
  return panel;
}

FigurePanel planePanel(const Scene& scene, PatientPlane plane, const PlaneSettings& planes) {
  FigurePanel panel;
  panel.scene = scene;
  panel.plane = plane;
  panel.planes = planes;
  if (!planes.window)
    panel.firstWindow = firstWindow(*scene.volume, histogramOf(*scene.volume));
  return panel;
}

std::string figureDescription(const Figure& figure, const std::vector<std::string>& volumePaths,
                              const NameInFile& named) {
  FigureDocument document{figure.settings, {}};
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const FigurePanel& panel = figure.panels[i];
    Scene scene = panel.scene;
    if (!scene.keep.source.empty())
      scene.keep.source = named(scene.keep.source, *scene.volume);
    document.panels.push_back({panel.name.toStdString(), panel.plane, panel.planes,
                               documentOf(scene, named(volumePaths[i], *scene.volume))});
  }
  return figureToJson(document);
}

} // namespace limn
