// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/QualitySection.h"

#include "widgets/controls/ValueSlider.h"

#include <QVBoxLayout>

namespace limn {
namespace {

NumberSpec stepSpec() {
  return {.label = QualitySection::tr("Step"),
          .help =
              QualitySection::tr("The distance between samples along a ray, in voxels: smaller is closer to "
                                 "exact, larger is faster."),
          .unit = QualitySection::tr("voxels"),
          .scale = {0.05, 4.0, true},
          .lowest = 0.01,
          .highest = 16.0,
          .defaultValue = Quality{}.stepVoxels,
          .decimals = 3};
}

NumberSpec terminationSpec() {
  return {.label = QualitySection::tr("Stop when opaque to"),
          .help =
              QualitySection::tr("A ray stops where so much light is already blocked: lower is faster but "
                                 "loses a little light, 1 never stops early."),
          .unit = {},
          .scale = {0.9, 1.0, false},
          .lowest = 0.01,
          .highest = 1.0,
          .defaultValue = Quality{}.earlyTermination,
          .decimals = 4};
}

} // namespace

QualitySection::QualitySection(QWidget* parent)
    : FoldingSection(tr("Quality"), parent),
      m_step(addNumber(new ValueSlider(stepSpec()), &Quality::stepVoxels)),
      m_termination(addNumber(new ValueSlider(terminationSpec()), &Quality::earlyTermination)) {
  setQuality(m_quality);
}

void QualitySection::setQuality(const Quality& quality) {
  m_quality = quality;
  m_step->setValue(quality.stepVoxels);
  m_termination->setValue(quality.earlyTermination);
}

ValueSlider* QualitySection::addNumber(ValueSlider* slider, double Quality::*member) {
  contents()->addWidget(slider);
  connect(slider, &ValueSlider::valueEdited, this, [this, member](double value, const Gesture& gesture) {
    m_quality.*member = value;
    emit qualityEdited(m_quality, gesture);
  });
  return slider;
}

} // namespace limn
