// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

class QLabel;

namespace limn {

class ChoiceRow;
class ColorButton;
class ValueSlider;

/// Fog: what is far fades to a colour, so that depth can be told.
class FogSection : public FoldingSection {
  Q_OBJECT

public:
  explicit FogSection(QWidget* parent = nullptr);

  void setScene(const Scene& scene);

signals:
  void fogEdited(const limn::Fog& fog, const limn::Gesture& gesture);

private:
  ValueSlider* addNumber(ValueSlider* slider, double Fog::*member);
  void edit(const Fog& fog, const Gesture& gesture);
  void showFog();

  Scene m_scene;
  ChoiceRow* m_mode;
  QWidget* m_colorRow;
  ColorButton* m_color;
  ValueSlider* m_density;
  ValueSlider* m_start;
  ValueSlider* m_end;
};

} // namespace limn
