// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/ShadingSection.h"

#include "widgets/controls/NumberSliders.h"

#include <QCheckBox>

#include <algorithm>

namespace limn {

void ShadingSection::setShading(const Shading& shading) {
  m_shading = shading;
  showShading();
}

void ShadingSection::setModelsShown(const std::vector<ShadingModel>& models) {
  m_models = models;
  showShading();
}

void ShadingSection::editAll(const Shading& shading, const Gesture& gesture) {
  m_shading = shading;
  showShading();
  emit shadingEdited(m_shading, gesture);
}

bool ShadingSection::shows(std::initializer_list<ShadingModel> models) const {
  return std::find_first_of(m_models.begin(), m_models.end(), models.begin(), models.end()) != m_models.end();
}

ValueSlider* ShadingSection::addNumber(const NumberSpec& spec, double Shading::*member) {
  auto* slider = new ValueSlider(spec);
  contents()->addWidget(slider);
  connect(slider, &ValueSlider::valueEdited, this,
          [this, member](double value, const Gesture& gesture) { edit(member, value, gesture); });
  return slider;
}

RangeSlider* ShadingSection::addRange(const NumberSpec& spec, CoefficientRange Shading::*member) {
  auto* slider = new RangeSlider(spec);
  contents()->addWidget(slider);
  connect(slider, &RangeSlider::rangeEdited, this,
          [this, member](double lower, double upper, const Gesture& gesture) {
            edit(member, CoefficientRange{lower, upper}, gesture);
          });
  return slider;
}

QCheckBox* ShadingSection::addSwitch(const QString& label, const QString& help, bool Shading::*member) {
  auto* box = new QCheckBox(label);
  box->setToolTip(help);
  box->setAccessibleName(label);
  contents()->addWidget(box);
  connect(box, &QAbstractButton::clicked, this,
          [this, member, label](bool checked) { edit(member, checked, switchGesture(label, checked)); });
  return box;
}

void setUnavailable(QCheckBox& box, const QString& reason, const QString& toolTip) {
  box.setEnabled(reason.isEmpty());
  box.setToolTip(reason.isEmpty() ? toolTip : reason);
}

} // namespace limn
