// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/QualitySection.h"

#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberSliders.h"

#include <QCheckBox>
#include <QVBoxLayout>

namespace limn {
namespace {

NumberSpec stepSpec() {
  return {.label = QualitySection::tr("Step"),
          .help = QualitySection::tr("The distance between samples along a ray, in voxels: smaller is closer "
                                     "to exact, larger is faster."),
          .unit = QualitySection::tr("voxels"),
          .scale = {0.05, 4.0, true},
          .lowest = 0.01,
          .highest = 16.0,
          .defaultValue = Quality{}.stepVoxels,
          .decimals = 3};
}

NumberSpec terminationSpec() {
  return {.label = QualitySection::tr("Stop when opaque to"),
          .help = QualitySection::tr("A ray stops where so much light is already blocked: lower is faster "
                                     "but loses a little light, 1 never stops early."),
          .scale = {0.9, 1.0, false},
          .lowest = 0.01,
          .defaultValue = Quality{}.earlyTermination,
          .decimals = 4};
}

} // namespace

QualitySection::QualitySection(QWidget* parent)
    : FoldingSection(tr("Quality"), parent),
      m_step(addNumber(new ValueSlider(stepSpec()), &Quality::stepVoxels)),
      m_termination(addNumber(new ValueSlider(terminationSpec()), &Quality::earlyTermination)) {
  addPreintegration();
  addJitter();
  setQuality(m_quality);
}

void QualitySection::setQuality(const Quality& quality) {
  m_quality = quality;
  m_step->setValue(quality.stepVoxels);
  m_termination->setValue(quality.earlyTermination);
  m_preintegration->setIndex(static_cast<int>(quality.preintegrated));
  m_jitter->setChecked(quality.jitter);
}

void QualitySection::addPreintegration() {
  m_preintegration = new ChoiceRow(
      tr("Curve between samples"),
      tr("Whether the curve is averaged from one sample to the next (pre-integration), so that narrow peaks "
         "are not stepped over; automatic does so where the step is too large for the curve."),
      {tr("Automatic"), tr("Always averaged"), tr("Never averaged")},
      static_cast<int>(Preintegration::automatic));
  contents()->addWidget(m_preintegration);
  connect(m_preintegration, &ChoiceRow::indexEdited, this, [this](int index, const Gesture& gesture) {
    m_quality.preintegrated = static_cast<Preintegration>(index);
    emit qualityEdited(m_quality, gesture);
  });
}

void QualitySection::addJitter() {
  m_jitter = new QCheckBox(tr("Shift the samples (jitter)"));
  m_jitter->setAccessibleName(m_jitter->text());
  m_jitter->setToolTip(tr("<p>Shifts each pixel's samples by a fixed random part of a step: rings from a "
                          "large step turn into fine grain.</p><p>On or off, default off.</p>"));
  contents()->addWidget(m_jitter);
  connect(m_jitter, &QAbstractButton::clicked, this, [this](bool on) {
    m_quality.jitter = on;
    emit qualityEdited(m_quality, {nextGestureId(), changeText(m_jitter->text())});
  });
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
