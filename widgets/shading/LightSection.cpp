// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/LightSection.h"

#include "scene/light/LightPresets.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/shading/LightBall.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QStandardItemModel>

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

NumberSpec smoothingSpec() {
  return {.label = LightSection::tr("Smooth normals"),
          .called = LightSection::tr("Smoothing of normals"),
          .help = LightSection::tr("Takes the terraces of thick slices out of the light; about 0.7 of the "
                                   "distance between slices is a good start. No surface moves."),
          .unit = QStringLiteral("mm"),
          .scale = {0.0, 6.0, false},
          .highest = mostGradientSmoothing,
          .decimals = 1};
}

QLabel* headingOf(const QString& text) {
  auto* heading = new QLabel(text);
  heading->setForegroundRole(QPalette::PlaceholderText);
  return heading;
}

} // namespace

glm::dvec3 travelDirection(const LightAngles& angles, LightAxes axes) {
  const double azimuth = glm::radians(angles.azimuthDeg);
  const double elevation = glm::radians(angles.elevationDeg);
  const double across = std::sin(azimuth) * std::cos(elevation);
  const double before = std::cos(azimuth) * std::cos(elevation);
  const double above = std::sin(elevation);
  // In LPS +x is left, +y posterior, +z superior; a camera looks forward.
  return axes == LightAxes::world ? glm::dvec3(-across, before, -above) : glm::dvec3(-across, -above, before);
}

LightAngles lightAngles(const glm::dvec3& travelDirection, LightAxes axes) {
  const double length = glm::length(travelDirection);
  if (length == 0.0)
    return {};
  const glm::dvec3 d = travelDirection / length;
  const glm::dvec3 from =
      axes == LightAxes::world ? glm::dvec3(-d.x, d.y, -d.z) : glm::dvec3(-d.x, d.z, -d.y);
  // Straight above or below every azimuth is right; 0 is the calmest.
  const double across = std::hypot(from.x, from.y);
  return {across < 1e-9 ? 0.0 : glm::degrees(std::atan2(from.x, from.y)),
          glm::degrees(std::asin(std::clamp(from.z, -1.0, 1.0)))};
}

LightSection::LightSection(QWidget* parent) : ShadingSection(tr("Light"), parent) {
  addPresets();
  addDirection();
  addTravel();
  addStrengths();
  addReflection();
  showShading();
  m_ofHeadlight.reset(); // it was nobody's
}

void LightSection::setCamera(const Camera& camera) {
  if (camera == m_camera)
    return;
  m_camera = camera;
  m_ball->setPlace(seenFromViewer(shading(), m_camera));
}

// The last choice is that of a light of one's own, which nobody can choose.
void LightSection::addPresets() {
  m_preset = new ChoiceRow(
      tr("Light"), tr("A whole light in one go; the picture keeps its brightness."),
      {tr("Headlight"), tr("Studio"), tr("Soft studio"), tr("Overcast"), tr("Physical"), tr("My own")}, 0);
  auto* model = qobject_cast<QStandardItemModel*>(m_preset->box()->model());
  model->item(static_cast<int>(lightPresets.size()))->setEnabled(false);
  contents()->addWidget(m_preset);
  connect(m_preset, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    const LightPreset preset = lightPresets.at(static_cast<std::size_t>(index));
    // Between other lights strengths are carried on.
    editAll(withLight(shading(), preset, preset == LightPreset::headlight ? m_ofHeadlight : std::nullopt),
            gesture);
    emit presetChosen(preset);
  });
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
  m_ball = new LightBall;
  contents()->addWidget(m_ball, 0, Qt::AlignHCenter);
  m_place =
      new ChoiceRow(tr("Lamp position"),
                    tr("Whether the lamp is where the viewer is, turns with the view, so that shadows fall "
                       "alike from every side, or stays with the patient."),
                    {tr("With the viewer"), tr("Turns with the view"), tr("Fixed")}, 0);
  m_azimuth =
      new ValueSlider(angleSpec(tr("Lamp around"),
                                tr("Where the lamp stands around the patient: 0° in front, 90° at the "
                                   "patient's left, −90° at the right; of a lamp that turns with the view: "
                                   "0° at the viewer, 90° to the right."),
                                180.0));
  m_elevation = new ValueSlider(
      angleSpec(tr("Lamp height"), tr("How high the lamp stands: 90° above, −90° below."), 90.0));
  for (QWidget* control : std::initializer_list<QWidget*>{m_place, m_azimuth, m_elevation})
    contents()->addWidget(control);
  connect(m_place, &ChoiceRow::indexEdited, this, &LightSection::placeLamp);
  connect(m_ball, &LightBall::placeEdited, this, [this](const glm::dvec3& place, const Gesture& gesture) {
    editAll(withLightSeenAt(shading(), place, m_camera), gesture);
  });
  const auto turn = [this](double LightAngles::*angle) {
    return [this, angle](double value, const Gesture& gesture) {
      const LightAxes axes = shading().lightAxes;
      LightAngles angles = lightAngles(shading().lightDirection.value_or(glm::dvec3(0.0)), axes);
      angles.*angle = value;
      edit(&Shading::lightDirection, std::optional(travelDirection(angles, axes)), gesture);
    };
  };
  connect(m_azimuth, &ValueSlider::valueEdited, this, turn(&LightAngles::azimuthDeg));
  connect(m_elevation, &ValueSlider::valueEdited, this, turn(&LightAngles::elevationDeg));
}

// The lamp stays where it is seen; one that was at the viewer goes a little above and to the left, as in
// anatomical drawings.
void LightSection::placeLamp(int place, const Gesture& gesture) {
  Shading placed = shading();
  const glm::dvec3 seen = shading().lightDirection ? seenFromViewer(shading(), m_camera)
                                                   : glm::normalize(glm::dvec3(-0.5, 0.6, 0.75));
  placed.lightDirection.reset();
  placed.lightAxes = LightAxes::world;
  if (place > 0) {
    placed.lightDirection = glm::dvec3(0.0, 0.0, 1.0); // any
    placed.lightAxes = place == 1 ? LightAxes::camera : LightAxes::world;
    placed = withLightSeenAt(placed, seen, m_camera);
  }
  editAll(placed, gesture);
}

ValueSlider* LightSection::addPercent(const QString& label, const QString& help, double initial,
                                      const std::function<double&(Shading&)>& number) {
  auto* slider = new ValueSlider({.label = label,
                                  .help = help,
                                  .unit = QStringLiteral("%"),
                                  .scale = {0.0, 100.0, false},
                                  .defaultValue = 100.0 * initial,
                                  .decimals = 0});
  contents()->addWidget(slider);
  connect(slider, &ValueSlider::valueEdited, this, [this, number](double value, const Gesture& gesture) {
    Shading changed = shading();
    number(changed) = value / 100.0;
    editAll(changed, gesture);
  });
  return slider;
}

void LightSection::addTravel() {
  contents()->addWidget(headingOf(tr("What stands in the way")));
  m_shadow = addPercent(tr("Shadows"), tr("How dark it is where tissue stands between a place and the lamp."),
                        0.0, [](Shading& shading) -> double& { return shading.shadow.strength; });
  m_softness =
      new ValueSlider({.label = tr("Softness"),
                       .called = tr("Softness of shadows"),
                       .help = tr("How large the lamp is: 0° casts hard shadows, 45° hardly any edge."),
                       .unit = QStringLiteral("°"),
                       .scale = {0.0, 45.0, false},
                       .defaultValue = Shadow().softnessDeg,
                       .decimals = 1});
  m_occlusion =
      addPercent(tr("Dark hollows"),
                 tr("How much less light from all sides reaches hollows and what lies close together "
                    "(occlusion)."),
                 0.0, [](Shading& shading) -> double& { return shading.occlusion.strength; });
  m_reach = new ValueSlider({.label = tr("Reach"),
                             .called = tr("Reach of the darkening"),
                             .help = tr("How far away what stands around a place still darkens it."),
                             .unit = QStringLiteral("mm"),
                             .scale = {1.0, 100.0, true},
                             .lowest = 0.1,
                             .highest = 1000.0,
                             .defaultValue = Occlusion().reachMm,
                             .decimals = 1});
  contents()->insertWidget(contents()->indexOf(m_occlusion), m_softness);
  contents()->addWidget(m_reach);
  connect(m_softness, &ValueSlider::valueEdited, this, [this](double value, const Gesture& gesture) {
    edit(&Shading::shadow, Shadow{shading().shadow.strength, value}, gesture);
  });
  connect(m_reach, &ValueSlider::valueEdited, this, [this](double value, const Gesture& gesture) {
    edit(&Shading::occlusion, Occlusion{shading().occlusion.strength, value}, gesture);
  });
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
  m_numbers.emplace_back(addNumber(smoothingSpec(), &Shading::gradientSmoothing),
                         &Shading::gradientSmoothing);
}

void LightSection::showDirection() {
  const Shading& shown = shading();
  const std::optional<LightPreset> preset = lightPresetOf(shown);
  m_preset->setIndex(preset ? static_cast<int>(*preset) : static_cast<int>(lightPresets.size()));
  if (preset == LightPreset::headlight)
    m_ofHeadlight = {shown.ambientIntensity, shown.lightIntensity};
  m_ball->setPlace(seenFromViewer(shown, m_camera));
  m_ball->setAmbient(shown.ambientIntensity / std::max(shown.ambientIntensity + shown.lightIntensity, 1e-6));
  m_place->setIndex(!shown.lightDirection ? 0 : shown.lightAxes == LightAxes::camera ? 1 : 2);
  if (!shown.lightDirection)
    return;
  const LightAngles angles = lightAngles(*shown.lightDirection, shown.lightAxes);
  m_azimuth->setValue(angles.azimuthDeg);
  m_elevation->setValue(angles.elevationDeg);
}

void LightSection::showTravel() {
  m_shadow->setValue(100.0 * shading().shadow.strength);
  m_softness->setValue(shading().shadow.softnessDeg);
  m_occlusion->setValue(100.0 * shading().occlusion.strength);
  m_reach->setValue(shading().occlusion.reachMm);
}

void LightSection::showShading() {
  for (const auto& [slider, member] : m_numbers)
    slider->setValue(shading().*member);
  showDirection();
  showTravel();
  m_reflection->setIndex(static_cast<int>(shading().reflection));
  m_highlightColor->setIndex(static_cast<int>(shading().specularColor));
  m_twoSided->setChecked(shading().twoSided);

  const bool lit = shows({ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust});
  const bool hasPaths = shows({ShadingModel::physical});
  const QString unlit = lit ? QString()
                        : hasPaths
                            ? tr("Physical light has its own strengths: they lie in the section below.")
                            : tr("The unlit model uses no light.");
  const QString nowhere = hasPaths ? QString() : unlit;
  for (const auto& [slider, member] : m_numbers) // surfaces of both follow smoothed normals
    slider->setUnavailable(member == &Shading::gradientSmoothing ? nowhere : unlit);
  for (ChoiceRow* row : {m_reflection, m_highlightColor})
    row->setUnavailable(unlit);
  m_preset->setUnavailable(nowhere);
  m_place->setUnavailable(nowhere);
  limn::setUnavailable(*m_twoSided, unlit, m_twoSidedHelp);
  m_ball->setUnavailable(nowhere);
  const bool isHeadlight = !shading().lightDirection;
  const QString moving =
      isHeadlight ? tr("The lamp is where the viewer is: drag it off, or choose another position.") : nowhere;
  m_azimuth->setUnavailable(moving);
  m_elevation->setUnavailable(moving);
  m_shadow->setUnavailable(isHeadlight && lit
                               ? tr("A lamp at the viewer casts no shadow that can be seen: drag it "
                                    "off, or choose another position.")
                               : unlit);
  m_softness->setUnavailable(hasPaths && !lit ? unlit : moving);
  m_occlusion->setUnavailable(unlit);
  m_reach->setUnavailable(unlit);
}

} // namespace limn
