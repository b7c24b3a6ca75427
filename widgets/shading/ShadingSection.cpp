// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/ShadingSection.h"

#include "widgets/controls/NumberSliders.h"

#include <QCheckBox>

#include <algorithm>

namespace limn {
namespace {

bool haveOneOf(const std::vector<ShadingModel>& all, std::initializer_list<ShadingModel> models) {
  return std::find_first_of(all.begin(), all.end(), models.begin(), models.end()) != all.end();
}

} // namespace

void ShadingSection::setShading(const Shading& shading) {
  m_shading = shading;
  showShading();
}

void ShadingSection::setModelsShown(const std::vector<ShadingModel>& models,
                                    const std::vector<ShadingModel>& kept) {
  m_models = models;
  m_kept = kept;
  showShading();
}

void ShadingSection::editAll(const Shading& shading, const Gesture& gesture) {
  m_shading = shading;
  showShading();
  emit shadingEdited(m_shading, gesture);
}

bool ShadingSection::shows(std::initializer_list<ShadingModel> models) const {
  return haveOneOf(m_models, models);
}

bool ShadingSection::keeps(std::initializer_list<ShadingModel> models) const {
  return haveOneOf(m_kept, models);
}

QString ShadingSection::whyUnused(std::initializer_list<ShadingModel> models, const QString& nowhere) const {
  if (shows(models))
    return {};
  return keeps(models) ? tr("The left side alone uses this, and keeps its look: swap the sides to edit it.")
                       : nowhere;
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
