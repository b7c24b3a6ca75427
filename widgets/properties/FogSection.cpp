// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/FogSection.h"

#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/properties/ProjectionSection.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double leftAtFarEnd = 0.2;

// A number of two digits reads better than one of sixteen.
double rounded(double number) {
  if (!(number > 0.0))
    return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return std::round(number / unit) * unit;
}

NumberSpec densitySpec() {
  return {.label = FogSection::tr("Density (ρ)"),
          .called = FogSection::tr("Density of the fog"),
          .help = FogSection::tr("How fast the picture fades with distance: more is thicker, 0 is no fog."),
          .unit = FogSection::tr("per mm"),
          .scale = {0.0001, 0.1, true},
          .lowest = 0.0,
          .highest = 100.0,
          .defaultValue = Fog{}.densityPerMm,
          .decimals = 5};
}

NumberSpec distanceSpec(const QString& label, const QString& called, const QString& help, double initial,
                        double farthest) {
  return {.label = label,
          .called = called,
          .help = help,
          .unit = FogSection::tr("mm"),
          .scale = {0.0, farthest, false},
          .highest = 1e6,
          .defaultValue = initial,
          .decimals = 1};
}

NumberSpec startSpec(double farthest) {
  return distanceSpec(FogSection::tr("Begins at"), FogSection::tr("Beginning of the fog"),
                      FogSection::tr("The distance from the viewer up to which the picture stays clear; "
                                     "zooming out moves the viewer away."),
                      Fog{}.startMm, farthest);
}

NumberSpec endSpec(double farthest) {
  return distanceSpec(
      FogSection::tr("Full at"), FogSection::tr("Distance of the full fog"),
      FogSection::tr("The distance from the viewer from which only the fog's colour is left."), Fog{}.endMm,
      farthest);
}

} // namespace

DepthRange depthRange(const Camera& camera, const Grid& grid) {
  const CameraBasis basis = basisOf(camera);
  DepthRange range{1e300, 0.0};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 place = boxCentreMm(grid) + grid.direction * ((side - 0.5) * boxSizeMm(grid));
    const double depth = std::max(0.0, glm::dot(place - camera.position, basis.forward));
    range.nearMm = std::min(range.nearMm, depth);
    range.farMm = std::max(range.farMm, depth);
  }
  return range;
}

Fog withFogMode(const Scene& scene, Fog::Mode mode) {
  const Fog initial;
  Fog fog = scene.fog;
  fog.mode = mode;
  if (mode == Fog::Mode::none || !scene.volume)
    return fog;
  const DepthRange depth = depthRange(scene.camera, scene.volume->grid());
  const bool untouched =
      fog.startMm == initial.startMm && fog.endMm == initial.endMm && fog.densityPerMm == 0.0;
  if (untouched) {
    fog.startMm = std::round(depth.nearMm);
    // F = (end - z)/(end - start) is a fifth at the far end.
    fog.endMm = std::round(depth.nearMm + (depth.farMm - depth.nearMm) / (1.0 - leftAtFarEnd));
    if (fog.color == initial.color)
      fog.color = scene.image.background;
  }
  const double length = std::max(1.0, depth.farMm - fog.startMm);
  // exp(-ρ·d) and exp(-(ρ·d)²) are a fifth at the far end.
  const double exponent = -std::log(leftAtFarEnd);
  if (fog.densityPerMm == 0.0 && mode == Fog::Mode::exp)
    fog.densityPerMm = rounded(exponent / length);
  if (fog.densityPerMm == 0.0 && mode == Fog::Mode::exp2)
    fog.densityPerMm = rounded(std::sqrt(exponent) / length);
  return fog;
}

FogSection::FogSection(QWidget* parent)
    : FoldingSection(tr("Fog"), parent),
      m_mode(new ChoiceRow(
          tr("Kind"), tr("How the picture fades to the fog's colour with the distance from the eye."),
          {tr("Off"), tr("Evenly (linear)"), tr("Gradually (exp)"), tr("Late, then fast (exp2)")},
          static_cast<int>(Fog::Mode::none))),
      m_colorRow(new QWidget), m_color(new ColorButton(tr("change colour of fog"))) {
  contents()->addWidget(m_mode);
  connect(m_mode, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    edit(withFogMode(m_scene, static_cast<Fog::Mode>(index)), gesture);
  });
  m_start = addNumber(new ValueSlider(startSpec(1000.0)), &Fog::startMm);
  m_end = addNumber(new ValueSlider(endSpec(1000.0)), &Fog::endMm);
  m_density = addNumber(new ValueSlider(densitySpec()), &Fog::densityPerMm);

  m_mode->setCalled(tr("Fog"));
  auto* row = new QHBoxLayout(m_colorRow);
  row->setContentsMargins(0, 0, 0, 0);
  auto* name = new QLabel(tr("Colour"));
  name->setBuddy(m_color);
  m_color->setAccessibleName(tr("Colour of the fog"));
  m_colorRow->setToolTip(
      tr("<p>The colour to which the distance fades; the background's own looks deepest.</p>"));
  row->addWidget(name, 1);
  row->addWidget(m_color);
  contents()->addWidget(m_colorRow);
  connect(m_color, &ColorButton::colorEdited, this, [this](const glm::dvec3& color, const Gesture& gesture) {
    Fog fog = m_scene.fog;
    fog.color = color;
    edit(fog, gesture);
  });
  showFog();
}

ValueSlider* FogSection::addNumber(ValueSlider* slider, double Fog::*member) {
  contents()->addWidget(slider);
  connect(slider, &ValueSlider::valueEdited, this, [this, member](double value, const Gesture& gesture) {
    Fog fog = m_scene.fog;
    fog.*member = value;
    edit(fog, gesture);
  });
  return slider;
}

void FogSection::setScene(const Scene& scene) {
  const bool sameFog = scene.fog == m_scene.fog && scene.projection == m_scene.projection;
  const bool otherVolume = scene.volume != m_scene.volume;
  m_scene = scene;
  if (otherVolume && scene.volume) {
    // Far enough for the volume in a view from somewhat further away than the usual.
    const DepthRange depth = depthRange(defaultCamera(scene.volume->grid()), scene.volume->grid());
    const double farthest = std::ceil(1.5 * depth.farMm / 100.0) * 100.0;
    m_start->setSpec(startSpec(farthest));
    m_end->setSpec(endSpec(farthest));
  }
  if (!sameFog || otherVolume)
    showFog();
}

void FogSection::edit(const Fog& fog, const Gesture& gesture) {
  m_scene.fog = fog;
  showFog();
  emit fogEdited(fog, gesture);
}

void FogSection::showFog() {
  const Fog& fog = m_scene.fog;
  const bool linear = fog.mode == Fog::Mode::linear;
  const bool exponential = fog.mode == Fog::Mode::exp || fog.mode == Fog::Mode::exp2;
  m_mode->setIndex(static_cast<int>(fog.mode));
  m_start->setValue(fog.startMm);
  m_end->setValue(fog.endMm);
  m_density->setValue(fog.densityPerMm);
  m_color->setColor(fog.color);
  m_start->setVisible(linear || exponential);
  m_end->setVisible(linear);
  m_density->setVisible(exponential);
  m_colorRow->setVisible(linear || exponential);
  if (!linear && !exponential)
    setSummary(tr("off"));
  else if (!usesFog(m_scene.projection))
    setSummary(tr("unused: this projection has no depth"));
  else if (exponential && fog.densityPerMm == 0.0)
    setSummary(tr("off: its density is 0"));
  else
    setSummary(tr("on"));
}

} // namespace limn
