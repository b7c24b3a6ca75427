// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/shading/ShadingSection.h"

namespace limn {

/// What counts as a strong boundary, and the robust model's extras against overflowing highlights.
class GradientSection : public ShadingSection {
  Q_OBJECT

public:
  explicit GradientSection(QWidget* parent = nullptr);

  QString unusedBecause() const override;

protected:
  void showShading() override;

private:
  void addReference();
  void addCurve();
  void addRobustExtras();
  void showReference();
  void showCurve();
  void showRobustExtras();

  ChoiceRow* m_reference = nullptr;
  ValueSlider* m_percent = nullptr;
  ValueSlider* m_fixed = nullptr;
  ChoiceRow* m_curve = nullptr;
  ValueSlider* m_curveParameter = nullptr;
  QCheckBox* m_energy = nullptr;
  QCheckBox* m_significanceOn = nullptr;
  RangeSlider* m_significance = nullptr;
  QCheckBox* m_kneeOn = nullptr;
  ValueSlider* m_knee = nullptr;
  QString m_energyHelp;
  QString m_significanceHelp;
  QString m_kneeHelp;
};

} // namespace limn
