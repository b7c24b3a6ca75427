// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

namespace limn {

class ValueSlider;

/// Closer to exact or faster: the sampling step and where a ray may stop.
class QualitySection : public FoldingSection {
  Q_OBJECT

public:
  explicit QualitySection(QWidget* parent = nullptr);

  void setQuality(const Quality& quality);

signals:
  void qualityEdited(const limn::Quality& quality, const limn::Gesture& gesture);

private:
  ValueSlider* addNumber(ValueSlider* slider, double Quality::*member);

  Quality m_quality;
  ValueSlider* m_step;
  ValueSlider* m_termination;
};

} // namespace limn
