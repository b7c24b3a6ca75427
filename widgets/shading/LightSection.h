// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/LightPresets.h"
#include "scene/view/Camera.h"
#include "widgets/shading/ShadingSection.h"

#include <glm/glm.hpp>

#include <functional>
#include <optional>

namespace limn {

class LightBall;

/// Where a light stands that does not come from the viewer: around what it lights, seen from the patient, or
/// of one that turns with the view, from the viewer.
struct LightAngles {
  double azimuthDeg = 0.0;   ///< -180..180: 0 in front (anterior), 90 at the patient's left; to the right
  double elevationDeg = 0.0; ///< -90..90: 90 above the head; above
};

/// The direction in which the light travels, unit length, in patient space (LPS), or right, up and forward.
glm::dvec3 travelDirection(const LightAngles& angles, LightAxes axes = LightAxes::world);

/// The angles of a direction of travel; the front for the zero vector.
LightAngles lightAngles(const glm::dvec3& travelDirection, LightAxes axes = LightAxes::world);

/// Where the light comes from and how bright it is, what it casts shadows of, and how tissue answers it.
class LightSection : public ShadingSection {
  Q_OBJECT

public:
  explicit LightSection(QWidget* parent = nullptr);

  QString unusedBecause() const override;

  /// From where the pictures are seen.
  void setCamera(const Camera& camera);

  /// Another volume comes: a headlight that is chosen is none that was there before.
  void forgetHeadlight() { m_ofHeadlight.reset(); }

signals:
  /// A whole light was chosen, after it was reported as an edit.
  void presetChosen(limn::LightPreset preset);

protected:
  void showShading() override;

private:
  void addPresets();
  void addDirection();
  void addTravel();
  void addStrengths();
  void addReflection();
  ValueSlider* addPercent(const QString& label, const QString& help, double initial,
                          const std::function<double&(Shading&)>& number);
  void placeLamp(int place, const Gesture& gesture);
  void showDirection();
  void showTravel();

  Camera m_camera;
  std::optional<LightStrengths> m_ofHeadlight; ///< that was there last: to it a headlight comes back
  ChoiceRow* m_preset = nullptr;
  LightBall* m_ball = nullptr;
  ValueSlider* m_shadow = nullptr;
  ValueSlider* m_softness = nullptr;
  ValueSlider* m_occlusion = nullptr;
  ValueSlider* m_reach = nullptr;

  std::vector<std::pair<ValueSlider*, double Shading::*>> m_numbers;
  ChoiceRow* m_place = nullptr;
  ValueSlider* m_azimuth = nullptr;
  ValueSlider* m_elevation = nullptr;
  ChoiceRow* m_reflection = nullptr;
  ChoiceRow* m_highlightColor = nullptr;
  QCheckBox* m_twoSided = nullptr;
  QString m_twoSidedHelp;
};

} // namespace limn
