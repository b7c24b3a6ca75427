// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

class QCheckBox;

namespace limn {

class ChoiceRow;
class ValueSlider;

/// Closer to exact or faster: the sampling step, where a ray may stop, and two ways to hide the steps.
class QualitySection : public FoldingSection {
  Q_OBJECT

public:
  explicit QualitySection(QWidget* parent = nullptr);

  void setQuality(const Quality& quality);

signals:
  void qualityEdited(const limn::Quality& quality, const limn::Gesture& gesture);

private:
  ValueSlider* addNumber(ValueSlider* slider, double Quality::*member);
  void addPreintegration();
  void addJitter();

  Quality m_quality;
  ValueSlider* m_step;
  ValueSlider* m_termination;
  ChoiceRow* m_preintegration = nullptr;
  QCheckBox* m_jitter = nullptr;
};

} // namespace limn
