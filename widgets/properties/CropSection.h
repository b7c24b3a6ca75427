// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

#include <array>

class QLabel;
class QPushButton;

namespace limn {

struct AxisName;
class RangeSlider;

/// What is cut away: a range along each axis of the volume, named by the patient's directions where they are
/// known.
class CropSection : public FoldingSection {
  Q_OBJECT

public:
  explicit CropSection(QWidget* parent = nullptr);

  void setScene(const Scene& scene);

signals:
  void cropEdited(const limn::CropBox& crop, const limn::Gesture& gesture);
  void turnRequested(); ///< the box shall lie as the picture is seen

private:
  struct Row {
    RangeSlider* range = nullptr;
    QLabel* extent = nullptr; ///< the same in slices and millimetres
  };

  AxisName axisName(int axis) const;
  void edit(int axis, double lowerPercent, double upperPercent, const Gesture& gesture);
  void showCrop();

  void cropToVisible();

  std::shared_ptr<const Volume> m_volume;
  CropBox m_crop;
  Scene m_scene; ///< tells what is visible
  std::array<Row, 3> m_rows;
  QPushButton* m_toVisible;
  QPushButton* m_turn;
  QPushButton* m_reset;
};

} // namespace limn
