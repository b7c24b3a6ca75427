// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/FigureText.h"

#include "scene/effects/EffectPlan.h"
#include "widgets/ValueText.h"
#include "widgets/figure/LabelLegend.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/properties/ProjectionSection.h"
#include "widgets/view/overlay/Titles.h"

#include <QObject>
#include <QStringList>

#include <algorithm>

namespace limn {
namespace {

// "a, b" where a note does not hold for every panel; empty where it does.
template <class Panels, class Holds>
QString lettersWhere(const Panels& panels, const Holds& holds) {
  QStringList letters;
  for (std::size_t i = 0; i < panels.size(); ++i)
    if (holds(panels[i]))
      letters << panelLetter(i);
  return letters.size() == static_cast<qsizetype>(panels.size()) ? QString()
                                                                 : letters.join(QStringLiteral(", "));
}

// One error for all panels is told once.
QString accuracyNote(const Figure& figure) {
  QStringList told;
  QStringList errors;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    if (const auto& levels = figure.panels[i].errorLevels; levels && !figure.panels[i].paths) {
      errors << promisedLevels(*levels);
      told << QStringLiteral("%1 (%2)").arg(errors.back(), panelLetter(i));
    }
  if (told.isEmpty())
    return {};
  const bool isOne = errors.count(errors.front()) == static_cast<qsizetype>(figure.panels.size());
  const auto isStated = [](const FigurePanel& panel) { return panel.isStated || !panel.errorLevels; };
  return (std::ranges::any_of(figure.panels, &FigurePanel::isAim)
              ? QObject::tr(
                    "Drawn for %1 of 255 levels of the exact picture; the file tells what was reached.")
          : std::ranges::all_of(figure.panels, isStated)
              ? QObject::tr("99.9 % of pixels within %1 of 255 levels of the exact picture (95 % sure).")
              : QObject::tr("Estimated within %1 of 255 levels of the exact picture."))
      .arg(isOne ? errors.front() : told.join(QStringLiteral(", ")));
}

// What hides parts of the volume in a panel's picture, or smooths its light; a slice shows all of it, with a
// line around what is kept.
QStringList remarksOn(const FigurePanel& panel) {
  if (panel.plane)
    return panel.planes.outlinesRegion && isRestricting(panel.scene.keep)
               ? QStringList{QObject::tr("The line is around what is kept")}
               : QStringList();
  QStringList texts{regionText(panel.scene.keep, true)};
  if (panel.scene.crop != CropBox() && !panel.cropHidesNothing.value_or(false))
    texts << QObject::tr("Cropped");
  if (smoothsNormals(panel.scene))
    texts << QObject::tr("Normals smoothed by %1 mm")
                 .arg(digitsNumber(panel.scene.shading.gradientSmoothing, 3));
  texts.removeAll(QString());
  return texts;
}

// Whose the curves are where labels have some of their own.
QStringList curvesOn(const PanelLabels& labels) {
  if (labels.curves.empty())
    return labels.undrawn == 0 ? QStringList() : QStringList{QObject::tr("Labels have curves of their own")};
  if (labels.undrawn == 0)
    return {QObject::tr(
        "Curves in colour are of the labels listed in these colours; the other curve is of the rest")};
  return {QObject::tr("Curves in colour are of the labels listed in these colours, those of %1 more are not "
                      "drawn, and the other curve is of the rest")
              .arg(labels.undrawn)};
}

// Of physical light its paths and what they differ by.
QStringList pathsOn(const FigurePanel& panel) {
  if (panel.plane || !panel.paths)
    return {};
  if (!panel.paths->rmsLevels)
    return {QObject::tr("Random paths: %1 a pixel").arg(panel.paths->paths)};
  if (panel.paths->isFiltered)
    return {QObject::tr("Random paths: %1 a pixel, their noise filtered, about %2 of 255 levels RMS left")
                .arg(panel.paths->paths)
                .arg(promisedLevels(*panel.paths->rmsLevels))};
  return {QObject::tr("Random paths: %1 a pixel, standard error %2 of 255 levels RMS")
              .arg(panel.paths->paths)
              .arg(promisedLevels(*panel.paths->rmsLevels))};
}

// Of each panel, once for those of which the same is said.
template <class Panels, class TextsOn>
QStringList notesOn(const Panels& panels, const TextsOn& textsOn) {
  std::vector<QStringList> all(panels.size());
  std::ranges::transform(panels, all.begin(), textsOn);
  QStringList notes;
  for (const QStringList& texts : all)
    for (const QString& text : texts) {
      const QString where =
          lettersWhere(all, [&](const QStringList& others) { return others.contains(text); });
      const QString note =
          where.isEmpty() ? QObject::tr("%1.").arg(text) : QObject::tr("%1 (%2).").arg(text, where);
      if (!notes.contains(note))
        notes << note;
    }
  return notes;
}

bool isInPerspective(const FigurePanel& panel) {
  return !panel.plane && panel.scene.camera.projection == Camera::Projection::perspective;
}

} // namespace

QString panelLetter(std::size_t index) {
  return QString(QChar(static_cast<char16_t>(u'a' + index)));
}

QString usualName(const FigurePanel& panel) {
  return panel.plane ? planeTitle(*panel.scene.volume, *panel.plane) : sideTitle(panel.scene);
}

QString panelDetails(const FigurePanel& panel) {
  if (!panel.plane) {
    QStringList details;
    if (!panel.name.contains(usualName(panel), Qt::CaseInsensitive))
      details << usualName(panel); // presets have the panel's name
    if (usesLight(panel.scene.projection))
      details << sideDetails(panel.scene, {});
    return details.join(QStringLiteral(" · "));
  }
  const PlaneContent content = planeContentOf(panel);
  // What is shown comes first.
  return windowText(content) + QStringLiteral(" · ") + slicePlaceText(content, *panel.plane);
}

PlaneContent planeContentOf(const FigurePanel& panel) {
  return {panel.scene.volume, panel.scene.transferFunction, panel.scene.keep, panel.scene.crop, panel.planes,
          panel.firstWindow};
}

PlaneFrame planeFrameOf(const FigurePanel& panel, const QSize& pixels) {
  const PlaneContent content = planeContentOf(panel);
  return planeFrame(seenGrid(content), *panel.plane, crosshairOf(content), QSizeF(pixels), 1.0, std::nullopt);
}

double mmPerPixelOf(const FigurePanel& panel, const QSize& pixels) {
  return panel.plane ? mmPerLogicalPixel(planeFrameOf(panel, pixels))
                     : mmPerPixel(panel.scene.camera, pixels.height());
}

std::optional<OrientationLetters> lettersOfPanel(const FigurePanel& panel) {
  if (!panel.scene.volume->info().orientationKnown)
    return std::nullopt;
  if (!panel.plane)
    return orientationLetters(panel.scene.camera);
  const PlaneAxes axes = axesOf(*panel.plane);
  return OrientationLetters{lettersOf(-axes.right), lettersOf(axes.right), lettersOf(-axes.down),
                            lettersOf(axes.down)};
}

bool hasCurve(const FigurePanel& panel) {
  return !panel.plane || panel.planes.isTinted;
}

QString notesOf(const Figure& figure) {
  return notesOf(figure, figureLabels(figure));
}

QString notesOf(const Figure& figure, const FigureLabels& labels) {
  const FigureSettings& settings = figure.settings;
  QStringList notes;
  if (settings.shows(FigureMark::accuracy))
    notes << accuracyNote(figure) << notesOn(figure.panels, pathsOn);
  if (settings.shows(FigureMark::curve))
    notes << notesOn(labels, curvesOn);
  if (settings.shows(FigureMark::region))
    notes << notesOn(figure.panels, remarksOn);
  if (settings.shows(FigureMark::scaleBar) && std::ranges::any_of(figure.panels, isInPerspective)) {
    const QString where = lettersWhere(figure.panels, isInPerspective);
    notes << (where.isEmpty()
                  ? QObject::tr("Scale at the depth of the turning point (perspective).")
                  : QObject::tr("Scale at the depth of the turning point (perspective: %1).").arg(where));
  }
  if (settings.shows(FigureMark::notForDiagnosis))
    notes << QObject::tr("Not for diagnosis.");
  notes.removeAll(QString());
  return notes.join(QLatin1Char(' '));
}

} // namespace limn
