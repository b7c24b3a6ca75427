// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/figure/FigureSources.h"

#include "app/figures/FigureMaker.h"
#include "widgets/figure/FigureText.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/properties/ProjectionSection.h"
#include "widgets/view/overlay/OrientationCube.h"
#include "widgets/view/overlay/Titles.h"

#include <QObject>

#include <algorithm>

namespace limn {
namespace {

PanelSource named(const QString& text, FigurePanel panel) {
  panel.name = usualName(panel);
  return {text, std::move(panel)};
}

PanelSource withLook(const QString& pattern, const Scene& scene, const QString& name) {
  FigurePanel panel;
  panel.scene = scene;
  panel.name = name;
  return {pattern.arg(name), std::move(panel)};
}

// As on screen, each by its own model, which is named where the two differ in it.
void addLooks(std::vector<PanelSource>& sources, const FigureIngredients& from) {
  if (!from.look)
    return;
  Comparison compared;
  compared.scene = from.scene;
  compared.layout = CompareLayout::sideBySide;
  compared.look = from.look;
  const std::vector<Scene> sides = scenesOfSides(compared);
  const bool haveOneModel = sideTitle(sides[0]) == sideTitle(sides[1]);
  for (int side = 0; side < 2; ++side) {
    const auto at = static_cast<std::size_t>(side);
    const QString name =
        haveOneModel ? QString::fromStdString(from.look->names[at]) : sideTitle(compared, side);
    sources.push_back(withLook(QObject::tr("Compared: %1"), sides[at], name));
  }
}

void addRemembered(std::vector<PanelSource>& sources, const FigureIngredients& from) {
  if (!from.remembered)
    return;
  Preset before = *from.remembered;
  before.isWhole = true;
  sources.push_back(
      withLook(QObject::tr("Remembered: %1"), withPreset(from.scene, before), QObject::tr("Before")));
}

void addScenes(std::vector<PanelSource>& sources, const FigureIngredients& from) {
  FigurePanel panel;
  panel.scene = from.scene;
  if (!usesLight(from.scene.projection)) {
    sources.push_back(named(QObject::tr("Picture: %1").arg(usualName(panel)), panel));
    return;
  }
  for (const ShadingModel model : shadingModels) {
    panel.scene.shading.model = model;
    sources.push_back(named(QObject::tr("Picture: %1").arg(usualName(panel)), panel));
  }
}

void addViews(std::vector<PanelSource>& sources, const FigureIngredients& from) {
  for (const NamedView& view : from.views) {
    Scene scene = from.scene;
    scene.camera = view.camera;
    sources.push_back(withLook(QObject::tr("View: %1"), scene, QString::fromStdString(view.name)));
  }
}

// From as far away as the picture is seen from, so that they have one scale.
void addSides(std::vector<PanelSource>& sources, const FigureIngredients& from) {
  for (const CubeFace& face : cubeFaces(*from.scene.volume)) {
    Scene scene = from.scene;
    Camera& camera = scene.camera;
    camera.position = camera.target + glm::distance(camera.position, camera.target) * face.outward;
    camera.up = face.up;
    sources.push_back(withLook(QObject::tr("View: %1"), scene, face.side));
  }
}

void addSlices(std::vector<PanelSource>& sources, const FigureIngredients& from) {
  for (const PatientPlane plane : patientPlanes) {
    FigurePanel panel;
    panel.scene = from.scene;
    panel.plane = plane;
    panel.planes = from.planes;
    panel.firstWindow = from.firstWindow;
    sources.push_back(named(QObject::tr("Slice: %1").arg(usualName(panel)), panel));
  }
}

void addPresets(std::vector<PanelSource>& sources, const FigureIngredients& from) {
  for (const Preset& preset : from.presets) {
    const QString name = QString::fromStdString(preset.name);
    const bool isFitted = std::ranges::count(from.fitted, preset.name) > 0;
    sources.push_back(withLook(QObject::tr("Preset: %1"), withPreset(from.scene, preset, true),
                               isFitted ? fittedWords(name) : presetWords(name)));
  }
}

} // namespace

std::vector<PanelSource> panelSources(const FigureIngredients& from) {
  std::vector<PanelSource> sources;
  addLooks(sources, from);
  addScenes(sources, from);
  addRemembered(sources, from);
  addViews(sources, from);
  addSides(sources, from);
  addSlices(sources, from);
  addPresets(sources, from);
  for (PanelSource& source : sources)
    source.panel.measurements = from.measurements;
  return sources;
}

std::vector<std::size_t> firstPanels(const std::vector<PanelSource>& sources, const FigureIngredients& from) {
  std::vector<std::size_t> panels;
  const auto add = [&](const auto& isMeant) {
    const auto found = std::ranges::find_if(sources, isMeant);
    if (found != sources.end() && panels.size() < mostPanels)
      panels.push_back(static_cast<std::size_t>(found - sources.begin()));
  };
  for (const Scene& side : from.sides)
    add([&](const PanelSource& source) { return !source.panel.plane && source.panel.scene == side; });
  if (panels.empty())
    panels.push_back(0);
  if (panels.size() == 1 && from.planes.layout != PlaneLayout::pictureOnly)
    for (const PatientPlane plane : patientPlanes)
      add([&](const PanelSource& source) { return source.panel.plane == plane; });
  return panels;
}

std::vector<PanelSource> sourcesOf(const LoadedFigure& figure) {
  std::vector<PanelSource> sources;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const FigurePanel panel = panelOf(figure.panels[i]);
    const QString letter = panelLetter(i);
    sources.push_back({panel.name.isEmpty() ? QObject::tr("From the file: %1").arg(letter)
                                            : QObject::tr("From the file: %1, %2").arg(letter, panel.name),
                       panel});
  }
  return sources;
}

} // namespace limn
