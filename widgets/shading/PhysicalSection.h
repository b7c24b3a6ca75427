// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/shading/ShadingSection.h"

#include <functional>

class QCheckBox;
class QLabel;

namespace limn {

/// What physical light has beside the place of its lamp (DEFINITION section 12): how tissue scatters, how
/// strong lamp and sky are, how the picture is exposed, and how long saved pictures are drawn.
class PhysicalSection : public ShadingSection {
  Q_OBJECT

public:
  explicit PhysicalSection(QWidget* parent = nullptr);

  QString unusedBecause() const override;

  /// How far saved pictures are drawn.
  ChoiceRow* until() const { return m_until; }

protected:
  void showShading() override;

private:
  using Number = std::function<double&(PhysicalLight&)>;

  /// `unit` is what 1 of the slider is of the number.
  void add(const NumberSpec& spec, double unit, const Number& number);
  void addHeading(const QString& text);
  void addTissue();
  void addLight();
  void addUntil();
  void editUntil(const Until& until, const Gesture& gesture);
  void showUntil();

  struct Row {
    ValueSlider* slider;
    double unit;
    Number number;
  };
  std::vector<Row> m_rows;
  ChoiceRow* m_until = nullptr;
  ValueSlider* m_untilNumber = nullptr;
  QCheckBox* m_filter = nullptr;
};

} // namespace limn
