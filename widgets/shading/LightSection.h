// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/shading/ShadingSection.h"

#include <glm/glm.hpp>

namespace limn {

/// Where a fixed light stands, seen from the patient.
struct LightAngles {
  double azimuthDeg = 0.0;   ///< -180..180: 0 in front (anterior), 90 at the patient's left
  double elevationDeg = 0.0; ///< -90..90: 90 above the head
};

/// The direction in which the light travels, unit length, patient space (LPS).
glm::dvec3 travelDirection(const LightAngles& angles);

/// The angles of a direction of travel; the front for the zero vector.
LightAngles lightAngles(const glm::dvec3& travelDirection);

/// How bright the light is, where it comes from, and how tissue answers it.
class LightSection : public ShadingSection {
  Q_OBJECT

public:
  explicit LightSection(QWidget* parent = nullptr);

  QString unusedBecause() const override;

protected:
  void showShading() override;

private:
  void addStrengths();
  void addDirection();
  void addReflection();
  void showDirection();

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
