// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figures/FigureMaker.h"

#include "accuracy/ErrorEstimate.h"
#include "accuracy/Tolerance.h"
#include "app/core/drawing/PathDrawing.h"
#include "app/core/drawing/ProcessCost.h"
#include "app/core/drawing/StatedAccuracy.h"
#include "planes/GreyWindows.h"
#include "scene/basics/MemoryBudget.h"
#include "scene/effects/EffectPlan.h"
#include "scene/framing/VisibleVoxels.h"
#include "scene/steps/LocalSteps.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/figure/FigureText.h"
#include "widgets/planes/PlanePictures.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

uchar byteOfShare(float value) {
  return static_cast<uchar>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

// What chance says of a picture that was drawn, or its paths; the same for the file.
std::optional<PictureAccuracy> state(FigurePanel& panel, const MadePicture& picture, const Effort& effort) {
  panel.isAim = false;
  if (picture.paths) {
    panel.paths =
        PanelPaths{picture.paths->paths, picture.paths->rmsLevels, picture.paths->filtered.has_value()};
    panel.isStated = false;
    panel.errorLevels.reset();
    return accuracyOf(*picture.paths);
  }
  const std::optional<ErrorByChance> chance =
      chanceOf(picture.scene, picture.image, {effort.threads, effort.isCancelled, {}});
  panel.isStated = chance.has_value();
  panel.errorLevels = chance ? std::optional(chance->levels) : std::nullopt;
  return chance ? std::optional(accuracyByChance(*chance)) : std::nullopt;
}

QImage withoutBackground(const Image& picture) {
  QImage bytes(picture.size.x, picture.size.y, QImage::Format_RGBA8888_Premultiplied);
  for (int y = 0; y < picture.size.y; ++y) {
    uchar* row = bytes.scanLine(y);
    for (int x = 0; x < picture.size.x; ++x)
      for (int channel = 0; channel < 4; ++channel)
        row[4 * x + channel] = byteOfShare(picture.at(x, y)[channel]);
  }
  return bytes;
}

QImage sliceOf(const FigurePanel& panel, const QSize& size, bool isTransparent) {
  QImage slice = PlanePictures().picture(planeContentOf(panel), planeFrameOf(panel, size).grid);
  if (isTransparent)
    return slice;
  // As dark as air beside it, so that the volume's edge does not look like a part of the patient.
  QImage opaque(size, QImage::Format_RGB32);
  opaque.fill(Qt::black);
  QPainter(&opaque).drawImage(0, 0, slice);
  return opaque;
}

Image floatsOf(const QImage& slice) {
  const QImage bytes = slice.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  Image image({bytes.width(), bytes.height()});
  for (int y = 0; y < bytes.height(); ++y) {
    const uchar* row = bytes.constScanLine(y);
    for (int x = 0; x < bytes.width(); ++x)
      image.at(x, y) = glm::vec4(row[4 * x], row[4 * x + 1], row[4 * x + 2], row[4 * x + 3]) / 255.0f;
  }
  return image;
}

// Of those that are cropped, whether that hides anything.
void judgeCrops(std::vector<FigurePanel>& panels, const Effort& effort) {
  for (FigurePanel& panel : panels)
    if (!panel.plane && panel.scene.crop != CropBox() && !panel.cropHidesNothing)
      panel.cropHidesNothing = cropsOnlyUnseen(panel.scene, {effort.threads, effort.isCancelled, {}});
}

std::vector<std::size_t> panelsWithScene(const Figure& figure) {
  std::vector<std::size_t> panels;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    if (!figure.panels[i].plane)
      panels.push_back(i);
  return panels;
}

std::vector<Scene> scenesOf(const Figure& figure, const std::vector<std::size_t>& panels) {
  std::vector<Scene> scenes;
  scenes.reserve(panels.size());
  for (const std::size_t panel : panels)
    scenes.push_back(figure.panels[panel].scene);
  return scenes;
}

bool isEmpty(const Image& image) {
  return std::ranges::all_of(image.pixels, [](const glm::vec4& pixel) { return pixel.a <= 0.0f; });
}

// Those that ask for a tolerance get the steps that keep it in small pictures.
std::vector<Scene> withStepsFound(std::vector<Scene> scenes, const glm::ivec2& size,
                                  const MakingOptions& order) {
  for (Scene& scene : scenes)
    if (needsSteps(scene))
      makeEach({scene}, size, order, [&](std::size_t, const MadePicture& picture) { scene = picture.scene; });
  return scenes;
}

Scene withStepDivided(Scene scene, double parts) {
  scene.quality = withSteps(scene.quality, scene.quality.stepVoxels / parts);
  return scene;
}

} // namespace

FigurePanel panelOf(const LoadedFigure::Panel& loaded) {
  FigurePanel panel;
  if (loaded.plane)
    panel = planePanel(loaded.scene.scene, *loaded.plane, loaded.planes);
  panel.scene = loaded.scene.scene;
  panel.measurements = loaded.scene.measurements;
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

std::string figureDescription(const MadeFigure& made, const std::vector<std::string>& volumePaths,
                              const NameInFile& named) {
  FigureDocument document{made.figure.settings, {}};
  for (std::size_t i = 0; i < made.figure.panels.size(); ++i) {
    const FigurePanel& panel = made.figure.panels[i];
    Scene scene = panel.scene;
    nameSources(scene.keep, [&](const std::string& labels) { return named(labels, *scene.volume); });
    SceneDocument shown = documentOf(scene, named(volumePaths[i], *scene.volume));
    shown.measurements = panel.measurements;
    std::optional<PictureAccuracy> accuracy = made.stated[i];
    if (!accuracy && !panel.plane && panel.errorLevels)
      accuracy = accuracyByEstimate(*panel.errorLevels);
    document.panels.push_back(
        {panel.name.toStdString(), panel.plane, panel.planes, std::move(shown), std::move(accuracy)});
  }
  return figureToJson(document);
}

MadeFigure makeFigure(const Figure& figure, const MakingOptions& order, FigurePixels pixels) {
  // Pictures come before what is said of them: room is kept for as many words, each with a number of its own.
  constexpr double wideLevels = 0.41;
  Figure told = figure;
  if (figure.settings.shows(FigureMark::accuracy))
    for (const std::size_t panel : panelsWithScene(figure)) {
      told.panels[panel].errorLevels = wideLevels + 0.01 * static_cast<double>(panel);
      told.panels[panel].isStated = true;
      if (isPhysical(told.panels[panel].scene))
        told.panels[panel].paths = PanelPaths{mostPaths, wideLevels};
    }
  judgeCrops(told.panels, order.effort);
  const FigureLayout layout = figureLayout(told);
  MadeFigure made = drawPanels(told, layout.pictureSize(), order, pixels);
  MakingOptions silent = order; // how far the figure is does not begin anew with these small pictures
  silent.effort.report = nullptr;
  made.figure = withErrors(made.figure, silent);
  made.layout = layout;
  return made;
}

MadeFigure drawPanels(const Figure& figure, const QSize& size, const MakingOptions& order,
                      FigurePixels pixels) {
  MadeFigure made{figure, {}, {}, {}, {}, {}};
  made.pictures.resize(figure.panels.size());
  made.stated.resize(figure.panels.size());
  if (pixels == FigurePixels::floats)
    made.floats.resize(figure.panels.size());
  const bool isTransparent = figure.settings.page == FigureSettings::Page::transparent;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    if (figure.panels[i].plane) {
      made.pictures[i] = sliceOf(figure.panels[i], size, isTransparent);
      if (pixels == FigurePixels::floats)
        made.floats[i] = floatsOf(sliceOf(figure.panels[i], size, true));
    }
  judgeCrops(made.figure.panels, order.effort);
  // Each scene by itself draws the picture that it has here.
  for (FigurePanel& panel : made.figure.panels) {
    panel.scene.image.width = size.width();
    panel.scene.image.height = size.height();
  }
  const std::vector<std::size_t> panels = panelsWithScene(figure);
  if (panels.empty())
    return made;
  makeEach(scenesOf(made.figure, panels), {size.width(), size.height()}, order,
           [&](std::size_t index, MadePicture picture) {
             const std::size_t panel = panels[index];
             if (isEmpty(picture.image))
               made.notes.push_back(QObject::tr("Panel %1 shows nothing: everything in view is transparent.")
                                        .arg(panelLetter(panel))
                                        .toStdString());
             made.pictures[panel] = isTransparent
                                        ? withoutBackground(picture.image)
                                        : overBackground(picture.image, picture.scene.image.background);
             made.figure.panels[panel].scene = picture.scene;
             if (figure.panels[panel].isStated)
               made.stated[panel] = state(made.figure.panels[panel], picture, order.effort);
             else if (picture.paths)
               made.stated[panel] = accuracyOf(*picture.paths);
             made.engine = picture.engine;
             for (const Message& said : picture.notes)
               if (const std::string note = translated(said).toStdString();
                   std::ranges::find(made.notes, note) == made.notes.end())
                 made.notes.push_back(note);
             if (pixels == FigurePixels::floats)
               made.floats[panel] = std::move(picture.image);
           });
  return made;
}

Figure withErrors(Figure figure, const MakingOptions& order) {
  if (!figure.settings.shows(FigureMark::accuracy))
    return figure;
  const QSize full = figureLayout(figure).pictureSize();
  constexpr double mostSide = 224.0;
  const double factor = std::min(1.0, mostSide / std::max(full.width(), full.height()));
  const glm::ivec2 size(std::max(1, static_cast<int>(full.width() * factor)),
                        std::max(1, static_cast<int>(full.height() * factor)));
  std::vector<std::size_t> panels = panelsWithScene(figure);
  std::erase_if(panels, [&](std::size_t panel) {
    return figure.panels[panel].errorLevels.has_value() || isPhysical(figure.panels[panel].scene);
  });
  std::vector<Scene> scenes;
  for (const Scene& scene : withStepsFound(scenesOf(figure, panels), size, order))
    for (const double parts : {1.0, 2.0, 4.0})
      scenes.push_back(withStepDivided(scene, parts));
  if (scenes.empty())
    return figure;
  std::vector<Image> images;
  bool canBeEstimated = true;
  ImageError ofFilter;
  MakingOptions told = order;
  told.tellsFilter = true;
  makeEach(scenes, size, told, [&](std::size_t index, MadePicture picture) {
    if (index % 3 == 0) {
      canBeEstimated = picture.canBeEstimated;
      ofFilter = picture.ofFilter;
    }
    images.push_back(std::move(picture.image));
    if (index % 3 != 2)
      return;
    if (!canBeEstimated)
      return images.clear();
    const ErrorEstimate steps =
        errorBeforeHalvings(imageError(images[0], images[1]), imageError(images[1], images[2]));
    figure.panels[panels[index / 3]].errorLevels =
        (hasTravellingLight(picture.scene) ? withLight : withFilter)(
            withEarlyEnds(steps, errorOfEarlyEnds(images[0], picture.scene)), ofFilter)
            .p99_9;
    images.clear();
  });
  return figure;
}

double bytesToMake(const FigureLayout& layout, FigurePixels pixels) {
  const auto countOf = [](const QSize& size) { return 1.0 * size.width() * size.height(); };
  const double picture = countOf(layout.pictureSize());
  const double pictures = picture * static_cast<double>(layout.pictures.size());
  const double figure = countOf(layout.size);
  constexpr double floatPixel = 16.0;
  constexpr double bytePixel = 4.0;
  // One picture is drawn at a time, twice where a driver hands it over; the figure is copied once to be
  // written.
  const double drawing = 2.0 * floatPixel * picture + bytePixel * pictures;
  const double writing = bytePixel * pictures + 2.0 * bytePixel * figure;
  if (pixels == FigurePixels::bytes)
    return std::max(drawing, writing);
  return floatPixel * pictures + std::max(drawing, writing + floatPixel * figure);
}

std::string memoryNote(const FigureLayout& layout, FigurePixels pixels) {
  constexpr double worthTelling = 1e9;
  const double bytes = bytesToMake(layout, pixels);
  const std::optional<double> free = freeMemory();
  if (bytes < worthTelling && hasMemoryFor(layout, pixels))
    return {};
  const auto gigabytes = [](double count) { return QObject::tr("%1 GB").arg(fixedNumber(count / 1e9, 1)); };
  const QString needs = QObject::tr("The figure has %1 × %2 pixels and takes %3 of memory while it is made")
                            .arg(layout.size.width())
                            .arg(layout.size.height())
                            .arg(gigabytes(bytes));
  return (free ? QObject::tr("%1; %2 are free.").arg(needs, gigabytes(*free)) : QObject::tr("%1.").arg(needs))
      .toStdString();
}

bool hasMemoryFor(const FigureLayout& layout, FigurePixels pixels) {
  const std::optional<double> free = freeMemory();
  return !free || bytesToMake(layout, pixels) < *free;
}

} // namespace limn
