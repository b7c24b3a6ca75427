// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/shading/ShadingSection.h"

#include <QString>

#include <array>

class QLabel;
class QPushButton;

namespace limn {

/// The shading model and the numbers that make it: highlight sharpness and boundary emphasis.
class ModelSection : public ShadingSection {
  Q_OBJECT

public:
  explicit ModelSection(QWidget* parent = nullptr);

  /// The models chosen for the pictures on screen, lit or not: one, or the two that are compared. `keptLook`
  /// is called the look at the left that keeps its own light; empty: none does.
  void setChosenModels(const std::vector<ShadingModel>& models, const QString& keptLook = {});

signals:
  /// Another model for a side of a comparison, 0 left, 1 right; a single picture's is its scene's.
  void sideModelChosen(int side, limn::ShadingModel model);

protected:
  void showShading() override;

private:
  std::vector<ShadingModel> m_chosen{ShadingModel::classic};
  QString noExponentRange() const;

  ChoiceRow* m_model; ///< of a single picture
  std::array<ChoiceRow*, 2> m_sides;
  QLabel* m_kept; ///< says which side is not edited
  QLabel* m_classicHeading;
  QLabel* m_rangesHeading; ///< above what follows boundaries
  ValueSlider* m_exponent;
  RangeSlider* m_exponentRange;
  RangeSlider* m_opacityRange;
  QPushButton* m_literal; ///< sets the paper's own numbers
};

/// The name of a shading model as the window shows it, translated.
QString modelName(ShadingModel model);

} // namespace limn
