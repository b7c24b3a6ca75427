// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/shading/ShadingSection.h"

#include <QString>

namespace limn {

/// The shading model and the numbers that make it: highlight sharpness and boundary emphasis.
class ModelSection : public ShadingSection {
  Q_OBJECT

public:
  explicit ModelSection(QWidget* parent = nullptr);

protected:
  void showShading() override;

private:
  ChoiceRow* m_model;
  ValueSlider* m_exponent;
  RangeSlider* m_exponentRange;
  RangeSlider* m_opacityRange;
};

/// The name of a shading model as the window shows it, translated.
QString modelName(ShadingModel model);

} // namespace limn
