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

/// The distances at which the volume begins and ends before the camera, mm; 0 ≤ near ≤ far.
struct DepthRange {
  double nearMm = 0.0;
  double farMm = 0.0;
};

/// Along the direction of view, of the corners of the box.
DepthRange depthRange(const Camera& camera, const Grid& grid);

/// The scene's fog switched to another mode. Numbers with which nothing would be seen (no density; a linear
/// fog that was never set) are replaced: it begins where the volume does, leaves a fifth of the colour at its
/// far end, and takes the colour of the background.
Fog withFogMode(const Scene& scene, Fog::Mode mode);

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
