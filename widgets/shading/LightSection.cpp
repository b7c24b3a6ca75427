// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/LightSection.h"

#include "widgets/controls/NumberSliders.h"

#include <QCheckBox>
#include <QLabel>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

NumberSpec strengthSpec(const QString& label, const QString& help, double initial) {
  return {.label = label, .help = help, .scale = {0.0, 2.0, false}, .highest = 10.0, .defaultValue = initial};
}

NumberSpec angleSpec(const QString& label, const QString& help, double limit) {
  return {.label = label,
          .help = help,
          .unit = QStringLiteral("°"),
          .scale = {-limit, limit, false},
          .decimals = 1};
}

QLabel* headingOf(const QString& text) {
  auto* heading = new QLabel(text);
  heading->setForegroundRole(QPalette::PlaceholderText);
  return heading;
}

} // namespace

glm::dvec3 travelDirection(const LightAngles& angles) {
  const double azimuth = glm::radians(angles.azimuthDeg);
  const double elevation = glm::radians(angles.elevationDeg);
  // In LPS +x is left, +y posterior, +z superior.
  const glm::dvec3 from(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                        std::sin(elevation));
  return -from;
}

LightAngles lightAngles(const glm::dvec3& travelDirection) {
  const double length = glm::length(travelDirection);
  if (length == 0.0)
    return {};
  const glm::dvec3 from = -travelDirection / length;
  // Straight above or below every azimuth is right; 0 is the calmest.
  const double across = std::hypot(from.x, from.y);
  return {across < 1e-9 ? 0.0 : glm::degrees(std::atan2(from.x, -from.y)),
          glm::degrees(std::asin(std::clamp(from.z, -1.0, 1.0)))};
}

LightSection::LightSection(QWidget* parent) : ShadingSection(tr("Light"), parent) {
  addStrengths();
  addDirection();
  addReflection();
  showShading();
}

QString LightSection::unusedBecause() const {
  return shows({ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust, ShadingModel::physical})
             ? QString()
             : tr("unused: this model is unlit");
}

void LightSection::addStrengths() {
  const Shading initial;
  const auto add = [this](const QString& label, const QString& help, double start, double Shading::*member) {
    m_numbers.emplace_back(addNumber(strengthSpec(label, help, start), member), member);
  };
  contents()->addWidget(headingOf(tr("Tissue reflects")));
  add(tr("Ambient (ka)"),
      tr("How much of the light from everywhere tissue gives back: it lifts the shadows."), initial.ambient,
      &Shading::ambient);
  add(tr("Diffuse (kd)"), tr("How strongly surfaces that face the light brighten: it shapes the form."),
      initial.diffuse, &Shading::diffuse);
  add(tr("Highlights (ks)"), tr("How bright the highlights are; 0 makes every surface dull."),
      initial.specular, &Shading::specular);
  contents()->addWidget(headingOf(tr("Strength of the light")));
  add(tr("From all sides (Ia)"), tr("The light that comes from everywhere and casts no form."),
      initial.ambientIntensity, &Shading::ambientIntensity);
  add(tr("From the lamp (Id)"), tr("The strength of the lamp that makes form and highlights."),
      initial.lightIntensity, &Shading::lightIntensity);
}

void LightSection::addDirection() {
  m_place = new ChoiceRow(tr("Lamp position"),
                          tr("Whether the lamp moves with the viewer or stays with the patient."),
                          {tr("With the viewer"), tr("Fixed")}, 0);
  m_azimuth = new ValueSlider(angleSpec(tr("Lamp around"),
                                        tr("Where a fixed lamp stands around the patient: 0° in front, 90° "
                                           "at the patient's left, −90° at the right."),
                                        180.0));
  m_elevation = new ValueSlider(angleSpec(
      tr("Lamp height"), tr("How high a fixed lamp stands: 90° above the head, −90° below the feet."), 90.0));
  for (QWidget* control : std::initializer_list<QWidget*>{m_place, m_azimuth, m_elevation})
    contents()->addWidget(control);
  connect(m_place, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    // From the front, a little above and to the left, as in anatomical drawings.
    edit(&Shading::lightDirection, index == 1 ? std::optional(travelDirection({30.0, 30.0})) : std::nullopt,
         gesture);
  });
  const auto turn = [this](double LightAngles::*angle) {
    return [this, angle](double value, const Gesture& gesture) {
      LightAngles angles = lightAngles(shading().lightDirection.value_or(glm::dvec3(0.0)));
      angles.*angle = value;
      edit(&Shading::lightDirection, travelDirection(angles), gesture);
    };
  };
  connect(m_azimuth, &ValueSlider::valueEdited, this, turn(&LightAngles::azimuthDeg));
  connect(m_elevation, &ValueSlider::valueEdited, this, turn(&LightAngles::elevationDeg));
}

void LightSection::addReflection() {
  m_reflection = addChoice(new ChoiceRow(tr("Highlight formula"),
                                         tr("How a highlight's shape follows from lamp and viewer."),
                                         {tr("Blinn-Phong"), tr("Phong")}, 0),
                           &Shading::reflection);
  m_highlightColor = addChoice(new ChoiceRow(tr("Highlight colour"),
                                             tr("Whether highlights take the tissue's colour or are white."),
                                             {tr("Tissue"), tr("White")}, 0),
                               &Shading::specularColor);
  m_twoSidedHelp = tr("<p>Lights the far side of thin walls too, so that cut or hollow parts do not turn "
                      "black.</p><p>On or off, default off.</p>");
  m_twoSided = addSwitch(tr("Light both sides"), m_twoSidedHelp, &Shading::twoSided);
}

void LightSection::showDirection() {
  const bool fixed = shading().lightDirection.has_value();
  m_place->setIndex(fixed ? 1 : 0);
  if (!fixed)
    return;
  const LightAngles angles = lightAngles(*shading().lightDirection);
  m_azimuth->setValue(angles.azimuthDeg);
  m_elevation->setValue(angles.elevationDeg);
}

void LightSection::showShading() {
  for (const auto& [slider, member] : m_numbers)
    slider->setValue(shading().*member);
  showDirection();
  m_reflection->setIndex(static_cast<int>(shading().reflection));
  m_highlightColor->setIndex(static_cast<int>(shading().specularColor));
  m_twoSided->setChecked(shading().twoSided);

  const bool lit = shows({ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust});
  const bool hasPaths = shows({ShadingModel::physical});
  const QString unlit = lit        ? QString()
                        : hasPaths ? tr("Physical light has strengths and highlights of its own.")
                                   : tr("The unlit model uses no light.");
  for (const auto& [slider, member] : m_numbers)
    slider->setUnavailable(unlit);
  for (ChoiceRow* row : {m_reflection, m_highlightColor})
    row->setUnavailable(unlit);
  const QString nowhere = hasPaths ? QString() : unlit;
  m_place->setUnavailable(nowhere);
  limn::setUnavailable(*m_twoSided, unlit, m_twoSidedHelp);
  const QString moving =
      shading().lightDirection ? nowhere : tr("The lamp moves with the viewer: choose \"Fixed\" first.");
  m_azimuth->setUnavailable(moving);
  m_elevation->setUnavailable(moving);
}

} // namespace limn
