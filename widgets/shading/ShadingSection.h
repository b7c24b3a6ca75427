// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/FoldingSection.h"

#include <QVBoxLayout>

#include <vector>

class QCheckBox;

namespace limn {

struct NumberSpec;
class RangeSlider;
class ValueSlider;

/// What the sections of the shading panel share: they show one Shading, and every control changes one of its
/// numbers. Which controls matter depends on the models in the pictures.
class ShadingSection : public FoldingSection {
  Q_OBJECT

public:
  using FoldingSection::FoldingSection;

  void setShading(const Shading& shading);
  /// The models that the shading lights in the pictures, and those of pictures that keep their own light.
  void setModelsShown(const std::vector<ShadingModel>& models, const std::vector<ShadingModel>& kept = {});

  /// Why nothing of this section matters for the models shown; empty where something does.
  virtual QString unusedBecause() const { return {}; }

signals:
  void shadingEdited(const limn::Shading& shading, const limn::Gesture& gesture);

protected:
  const Shading& shading() const { return m_shading; }
  const std::vector<ShadingModel>& modelsShown() const { return m_models; }

  /// True where one of the pictures that the shading lights uses one of `models`.
  bool shows(std::initializer_list<ShadingModel> models) const;
  /// The same of a picture that keeps its light.
  bool keeps(std::initializer_list<ShadingModel> models) const;
  /// Why a control for `models` changes nothing; `nowhere` where no picture uses one, empty where one does.
  QString whyUnused(std::initializer_list<ShadingModel> models, const QString& nowhere) const;

  /// Changes one thing, shows and reports it.
  template <class Member, class Value>
  void edit(Member Shading::*member, const Value& value, const Gesture& gesture) {
    m_shading.*member = value;
    showShading();
    emit shadingEdited(m_shading, gesture);
  }

  /// Changes several things at once.
  void editAll(const Shading& shading, const Gesture& gesture);

  /// A row that chooses among the values of an enumeration, in their order.
  template <class Choice>
  ChoiceRow* addChoice(ChoiceRow* row, Choice Shading::*member) {
    contents()->addWidget(row);
    connect(row, &ChoiceRow::indexEdited, this, [this, member](int index, const Gesture& gesture) {
      edit(member, static_cast<Choice>(index), gesture);
    });
    return row;
  }
  ValueSlider* addNumber(const NumberSpec& spec, double Shading::*member);
  RangeSlider* addRange(const NumberSpec& spec, CoefficientRange Shading::*member);
  QCheckBox* addSwitch(const QString& label, const QString& help, bool Shading::*member);

  /// Brings every control up to date.
  virtual void showShading() = 0;

private:
  Shading m_shading;
  std::vector<ShadingModel> m_models{ShadingModel::classic};
  std::vector<ShadingModel> m_kept;
};

/// Disables a check box and says why in its tool tip; an empty reason enables it. `toolTip` is its usual one.
void setUnavailable(QCheckBox& box, const QString& reason, const QString& toolTip);

} // namespace limn
