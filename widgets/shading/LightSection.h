// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/shading/ShadingSection.h"

namespace limn {

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
