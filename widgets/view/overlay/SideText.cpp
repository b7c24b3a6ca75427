// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/SideText.h"

#include "widgets/ValueText.h"
#include "widgets/properties/ProjectionSection.h"
#include "widgets/shading/ModelSection.h"
#include "widgets/view/status/PictureStatusText.h"

#include <QObject>

namespace limn {
namespace {

QString number(double value) {
  return digitsNumber(value, 4);
}

QString rangeText(const CoefficientRange& range) {
  return QStringLiteral("%1–%2").arg(number(range.atFlat), number(range.atBoundary));
}

QString lightingText(const Shading& shading) {
  switch (shading.model) {
  case ShadingModel::none:
    return {};
  case ShadingModel::classic:
    return QObject::tr("SP %1").arg(number(shading.exponent));
  case ShadingModel::enhanced:
  case ShadingModel::robust:
    return QObject::tr("SP %1 · O %2").arg(rangeText(shading.exponentRange), rangeText(shading.opacityRange));
  }
  return {};
}

} // namespace

QString sideTitle(const Scene& scene) {
  return usesLight(scene.projection) ? modelName(scene.shading.model) : projectionName(scene.projection);
}

QString sideTitle(const Comparison& comparison, int side) {
  QString title = sideTitle(sceneOfSide(comparison, side));
  if (!comparison.look || comparison.layout == CompareLayout::single)
    return title;
  const std::string& name = comparison.look->names[static_cast<std::size_t>(side)];
  return QStringLiteral("%1 · %2").arg(QString::fromStdString(name), title);
}

QStringList sideDetails(const Scene& scene, const SideState& state) {
  QStringList parts;
  if (state.measuredLevels)
    parts << QObject::tr("within %1 levels").arg(promisedLevels(*state.measuredLevels));
  else if (state.estimate && !state.isRough && state.isResolved)
    parts << QObject::tr("within %1 levels").arg(levelsText(state.estimate->p99_9));
  if (state.completeMs)
    parts << timeText(*state.completeMs);
  if (state.contrast)
    parts << QObject::tr("contrast %1").arg(fixedNumber(*state.contrast, 3));
  if (state.overflow)
    parts << QObject::tr("overflow %1 %").arg(fixedNumber(100.0 * state.overflow->share, 1));
  const QString lighting = usesLight(scene.projection) ? lightingText(scene.shading)
                                                       : QObject::tr("unlit, the same with every model");
  if (!lighting.isEmpty())
    parts << lighting;
  return parts;
}

} // namespace limn
