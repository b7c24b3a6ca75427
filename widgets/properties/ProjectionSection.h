// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

class QLabel;

namespace limn {

class ChoiceRow;
class ValueSlider;

/// How a ray becomes a pixel, and the value of the surface where one is shown.
class ProjectionSection : public FoldingSection {
  Q_OBJECT

public:
  explicit ProjectionSection(QWidget* parent = nullptr);

  void setScene(const Scene& scene);

signals:
  void projectionEdited(limn::Projection projection, const limn::Gesture& gesture);
  void isovalueEdited(double isovalue, const limn::Gesture& gesture);

private:
  void show(Projection projection);

  std::shared_ptr<const Volume> m_volume; ///< whose values the slider spans
  ChoiceRow* m_projection;
  QLabel* m_meaning;
  ValueSlider* m_isovalue;
};

/// "Maximum (MIP)": a clinician's word, the term in brackets.
QString projectionName(Projection projection);

/// True where the projection shows a surface at the isovalue.
bool usesIsovalue(Projection projection);

/// True where the projection is lit by the shading model.
bool usesLight(Projection projection);

/// True where the opacity along the ray counts, and with it the curve over the gradient.
bool usesGradientOpacity(Projection projection);

/// True where the projection has a colour that fog can change.
bool usesFog(Projection projection);

} // namespace limn
