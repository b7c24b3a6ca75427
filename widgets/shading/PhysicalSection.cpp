// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/PhysicalSection.h"

#include "widgets/controls/NumberSliders.h"

#include <QCheckBox>
#include <QLabel>

#include <cmath>
#include <numbers>

namespace limn {
namespace {

constexpr double percent = 0.01;
constexpr double mostRadiance = 1e6; // of a scene file

NumberSpec untilPathsSpec() {
  return {.label = PhysicalSection::tr("Paths a pixel"),
          .help =
              PhysicalSection::tr("Four times as many paths halve the noise, and take four times as long."),
          .scale = {1.0, 16384.0, true},
          .highest = mostPaths,
          .defaultValue = static_cast<double>(UntilPaths().paths),
          .decimals = 0};
}

NumberSpec untilLevelsSpec() {
  return {.label = PhysicalSection::tr("Noise left"),
          .called = PhysicalSection::tr("Noise that may be left"),
          .help =
              PhysicalSection::tr("The standard error that may be left, RMS over the picture, in 255 levels "
                                  "of brightness; half of it takes four times as long."),
          .unit = PhysicalSection::tr("levels"),
          .unitOfOne = PhysicalSection::tr("level"),
          .scale = {0.1, 20.0, true},
          .lowest = 0.01,
          .highest = 255.0,
          .defaultValue = UntilLevels().levels};
}

NumberSpec untilSecondsSpec() {
  return {.label = PhysicalSection::tr("Time for it"),
          .called = PhysicalSection::tr("Time for a picture"),
          .help = PhysicalSection::tr("How long a picture may take."),
          .unit = PhysicalSection::tr("s"),
          .scale = {1.0, 3600.0, true},
          .lowest = 0.1,
          .highest = mostPathSeconds,
          .defaultValue = UntilSeconds().seconds,
          .decimals = 1};
}

enum UntilChoice { paths, levels, seconds };

// The number of an end, and the same end with another one.
double numberOf(const Until& until) {
  if (const auto* end = std::get_if<UntilLevels>(&until))
    return end->levels;
  if (const auto* end = std::get_if<UntilSeconds>(&until))
    return end->seconds;
  return std::get<UntilPaths>(until).paths;
}

Until untilNumber(const Until& until, double number) {
  if (std::holds_alternative<UntilLevels>(until))
    return UntilLevels{number};
  if (std::holds_alternative<UntilSeconds>(until))
    return UntilSeconds{number};
  return UntilPaths{static_cast<int>(std::lround(number))};
}

} // namespace

PhysicalSection::PhysicalSection(QWidget* parent) : ShadingSection(tr("Physical light"), parent) {
  addTissue();
  addLight();
  addUntil();
  showShading();
}

QString PhysicalSection::unusedBecause() const {
  const bool isUsed = shows({ShadingModel::physical}) || keeps({ShadingModel::physical}); // saved likewise
  return isUsed ? QString() : tr("unused: not in this model");
}

void PhysicalSection::add(const NumberSpec& spec, double unit, const Number& number) {
  auto* slider = new ValueSlider(spec);
  contents()->addWidget(slider);
  m_rows.push_back({slider, unit, number});
  connect(slider, &ValueSlider::valueEdited, this,
          [this, unit, number](double value, const Gesture& gesture) {
            PhysicalLight changed = shading().physical;
            number(changed) = unit * value;
            edit(&Shading::physical, changed, gesture);
          });
}

void PhysicalSection::addHeading(const QString& text) {
  auto* heading = new QLabel(text);
  heading->setForegroundRole(QPalette::PlaceholderText);
  contents()->addWidget(heading);
}

void PhysicalSection::addTissue() {
  const PhysicalLight initial;
  addHeading(tr("Tissue scatters"));
  add({.label = tr("Density"),
       .help = tr("How dense everything is beside what the curve says: thinner lets light deeper in, denser "
                  "keeps it at the surface."),
       .unit = QStringLiteral("×"),
       .scale = {0.1, 10.0, true},
       .lowest = 0.01,
       .highest = 100.0,
       .defaultValue = initial.density},
      1.0, [](PhysicalLight& light) -> double& { return light.density; });
  add({.label = tr("Forward scatter (g)"),
       .help = tr("Where light goes that hits something inside tissue: above 0 rather on, below 0 rather "
                  "back, at 0 all ways alike. Real tissue lies near 0.9."),
       .scale = {-0.95, 0.95, false},
       .defaultValue = initial.anisotropy},
      1.0, [](PhysicalLight& light) -> double& { return light.anisotropy; });
  add({.label = tr("Surfaces"),
       .help = tr("How much of the light that meets a clear boundary comes back from it as from a surface, "
                  "instead of going on in all directions."),
       .unit = QStringLiteral("%"),
       .scale = {0.0, 100.0, false},
       .defaultValue = initial.surface / percent,
       .decimals = 0},
      percent, [](PhysicalLight& light) -> double& { return light.surface; });
  add({.label = tr("Gloss"),
       .help = tr("How much of that is a highlight; the rest comes back matt, in the tissue's colour."),
       .unit = QStringLiteral("%"),
       .scale = {0.0, 100.0, false},
       .defaultValue = initial.specularShare / percent,
       .decimals = 0},
      percent, [](PhysicalLight& light) -> double& { return light.specularShare; });
}

void PhysicalSection::addLight() {
  const PhysicalLight initial;
  addHeading(tr("Lamp and sky"));
  add({.label = tr("Lamp strength"),
       .help = tr("At 1 a white surface that faces the lamp shows as white."),
       .unit = QStringLiteral("×"),
       .scale = {0.0, 4.0, false},
       .highest = mostRadiance / std::numbers::pi,
       .defaultValue = initial.keyIrradiance / std::numbers::pi},
      std::numbers::pi, [](PhysicalLight& light) -> double& { return light.keyIrradiance; });
  add({.label = tr("Lamp size"),
       .help = tr("How large the lamp is, as the angle from its middle to its rim: 0° casts hard shadows, "
                  "45° hardly any edge."),
       .unit = QStringLiteral("°"),
       .scale = {0.0, 45.0, false},
       .defaultValue = initial.keyRadiusDeg,
       .decimals = 1},
      1.0, [](PhysicalLight& light) -> double& { return light.keyRadiusDeg; });
  const NumberSpec sky{.label = tr("Sky above"),
                       .help = tr("The light that comes from all around, here from straight above; 1 is as "
                                  "bright as white paper under the lamp."),
                       .unit = QStringLiteral("×"),
                       .scale = {0.0, 2.0, false},
                       .highest = mostRadiance,
                       .defaultValue = initial.sky.above};
  add(sky, 1.0, [](PhysicalLight& light) -> double& { return light.sky.above; });
  NumberSpec below = sky;
  below.label = tr("Sky below");
  below.help = tr("The same from straight below; between both it changes evenly.");
  below.defaultValue = initial.sky.below;
  add(below, 1.0, [](PhysicalLight& light) -> double& { return light.sky.below; });
  add({.label = tr("Exposure"),
       .help =
           tr("Brightens or darkens the whole picture, as a camera does: each step of 1 doubles its light. "
              "No path is followed anew."),
       .unit = QStringLiteral("EV"),
       .scale = {-4.0, 4.0, false},
       .lowest = -20.0,
       .highest = 20.0,
       .defaultValue = initial.exposureEv,
       .decimals = 1},
      1.0, [](PhysicalLight& light) -> double& { return light.exposureEv; });
}

// The window itself goes on as long as nothing moves.
void PhysicalSection::addUntil() {
  addHeading(tr("Saved pictures"));
  m_until = new ChoiceRow(tr("Drawn until"),
                          tr("When a picture that is saved, filed or put into a figure has enough paths; the "
                             "window goes on while nothing moves."),
                          {tr("A number of paths"), tr("Little noise is left"), tr("Its time is up")}, paths);
  m_untilNumber = new ValueSlider(untilPathsSpec());
  contents()->addWidget(m_until);
  contents()->addWidget(m_untilNumber);
  connect(m_until, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    editUntil(index == levels    ? Until(UntilLevels{})
              : index == seconds ? Until(UntilSeconds{})
                                 : Until(UntilPaths{}),
              gesture);
  });
  connect(m_untilNumber, &ValueSlider::valueEdited, this, [this](double value, const Gesture& gesture) {
    editUntil(untilNumber(shading().physical.until, value), gesture);
  });
  m_filter = new QCheckBox(tr("Filter the noise that is left"));
  m_filter->setAccessibleName(m_filter->text());
  contents()->addWidget(m_filter);
  connect(m_filter, &QAbstractButton::clicked, this, [this](bool checked) {
    PhysicalLight changed = shading().physical;
    changed.filtersNoise = checked;
    edit(&Shading::physical, changed,
         {nextGestureId(), checked ? tr("noise filter on") : tr("noise filter off")});
  });
}

void PhysicalSection::editUntil(const Until& until, const Gesture& gesture) {
  PhysicalLight changed = shading().physical;
  changed.until = until;
  edit(&Shading::physical, changed, gesture);
}

void PhysicalSection::showUntil() {
  const Until& until = shading().physical.until;
  const auto choice = static_cast<UntilChoice>(until.index());
  m_until->setIndex(choice);
  m_untilNumber->setSpec(choice == levels    ? untilLevelsSpec()
                         : choice == seconds ? untilSecondsSpec()
                                             : untilPathsSpec());
  m_untilNumber->setValue(numberOf(until));
}

void PhysicalSection::showShading() {
  PhysicalLight shown = shading().physical;
  const QString nowhere = tr("Only physical light has this, and no picture is drawn in it.");
  const QString reason = whyUnused({ShadingModel::physical}, nowhere);
  for (const Row& row : m_rows) {
    row.slider->setValue(row.number(shown) / row.unit);
    row.slider->setUnavailable(reason);
  }
  showUntil();
  // Of every picture, also of one that keeps its light.
  const QString unsaved = keeps({ShadingModel::physical}) ? QString() : reason;
  m_until->setUnavailable(unsaved);
  m_untilNumber->setUnavailable(unsaved);
  m_filter->setChecked(shown.filtersNoise);
  setUnavailable(
      *m_filter, unsaved,
      tr("Means over pixels that show the same take the grain away, and a little of the finest "
         "detail with it. What that changed, and what error is left, is said with the picture. The "
         "window shows pictures without it."));
}

} // namespace limn
