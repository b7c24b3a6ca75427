// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/ProjectionSection.h"

#include "widgets/ValueText.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberSliders.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

// In the order of Projection.
QStringList projectionNames() {
  return {ProjectionSection::tr("Tissue (composite)"),
          ProjectionSection::tr("Maximum (MIP)"),
          ProjectionSection::tr("Minimum (MinIP)"),
          ProjectionSection::tr("Average"),
          ProjectionSection::tr("X-ray"),
          ProjectionSection::tr("Surface (isosurface)"),
          ProjectionSection::tr("Surface and tissue")};
}

// In the order of Projection.
QStringList projectionMeanings() {
  return {ProjectionSection::tr("Tissue as the opacity curve shows it, lit; what is near hides what lies "
                                "behind it."),
          ProjectionSection::tr(
              "The largest value along each ray: contrast-filled vessels, calcium, metal. Depth is lost."),
          ProjectionSection::tr("The smallest value along each ray: airways, air trapping. Black where the "
                                "curve is transparent at that value; crop the air around the body."),
          ProjectionSection::tr("The mean value along each ray, like one thick slice. Air lowers the mean: "
                                "make the curve opaque at lower values, or crop."),
          ProjectionSection::tr("White where much is opaque along the ray, as on a radiograph. Lower the "
                                "overall opacity where all is white."),
          ProjectionSection::tr("The first surface at the value below, solid and lit."),
          ProjectionSection::tr("Hybrid: a solid surface at the value below, seen through the tissue before "
                                "it.")};
}

NumberSpec isovalueSpec(const Volume* volume) {
  const ValueRange range = volume ? volume->range() : ValueRange{0.0, 1.0};
  const double width = range.highest - range.lowest;
  // Beyond the data there is no surface; a constant volume still needs a track.
  const double highest = width > 0.0 ? range.highest : range.lowest + 1.0;
  return {.label = ProjectionSection::tr("Surface at"),
          .called = ProjectionSection::tr("Value of the surface"),
          .help = ProjectionSection::tr(
              "The value at which the surface lies: 300 HU is bone, −300 HU the skin of a CT."),
          .unit = volume ? QString::fromStdString(volume->info().unit) : QString(),
          .scale = {range.lowest, highest, false},
          .defaultValue = std::clamp(Scene{}.isovalue, range.lowest, highest),
          .decimals = decimalsFor((highest - range.lowest) / 2000.0)};
}

} // namespace

QString projectionName(Projection projection) {
  return projectionNames().at(static_cast<int>(projection));
}

bool usesIsovalue(Projection projection) {
  return projection == Projection::isosurface || projection == Projection::compositeIsosurface;
}

bool usesLight(Projection projection) {
  return projection == Projection::composite || usesIsovalue(projection);
}

bool usesGradientOpacity(Projection projection) {
  return projection == Projection::composite || projection == Projection::compositeIsosurface;
}

bool usesFog(Projection projection) {
  return usesLight(projection);
}

ProjectionSection::ProjectionSection(QWidget* parent)
    : FoldingSection(tr("Projection"), parent),
      m_projection(new ChoiceRow(tr("Shows"), tr("What each ray through the volume becomes in the picture."),
                                 projectionNames(), static_cast<int>(Projection::composite))),
      m_meaning(new QLabel), m_isovalue(new ValueSlider(isovalueSpec(nullptr))) {
  for (int i = 0; i < m_projection->box()->count(); ++i)
    m_projection->box()->setItemData(i, projectionMeanings().at(i), Qt::ToolTipRole);
  m_projection->setCalled(tr("Projection"));
  m_meaning->setWordWrap(true);
  m_meaning->setForegroundRole(QPalette::PlaceholderText);
  for (QWidget* control : std::initializer_list<QWidget*>{m_projection, m_meaning, m_isovalue})
    contents()->addWidget(control);
  show(Projection::composite);
  connect(m_projection, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    show(static_cast<Projection>(index));
    emit projectionEdited(static_cast<Projection>(index), gesture);
  });
  connect(m_isovalue, &ValueSlider::valueEdited, this, &ProjectionSection::isovalueEdited);
}

void ProjectionSection::setScene(const Scene& scene) {
  if (scene.volume != m_volume) {
    m_volume = scene.volume;
    m_isovalue->setSpec(isovalueSpec(m_volume.get()));
  }
  m_isovalue->setValue(scene.isovalue);
  show(scene.projection);
}

void ProjectionSection::show(Projection projection) {
  m_projection->setIndex(static_cast<int>(projection));
  m_meaning->setText(projectionMeanings().at(static_cast<int>(projection)));
  m_isovalue->setVisible(usesIsovalue(projection));
}

} // namespace limn
