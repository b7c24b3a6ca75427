// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"
#include "widgets/controls/LabelledRow.h"

#include <QWidget>

namespace limn {

class NumberField;
class ResetLabel;
class TrackSlider;

/// One number in one line: its name, a slider, and a field to type in. A double click on the name resets.
class ValueSlider : public QWidget {
  Q_OBJECT

public:
  explicit ValueSlider(const NumberSpec& spec, QWidget* parent = nullptr);

  /// Other words and limits; the number stays.
  void setSpec(const NumberSpec& spec);

  void setValue(double value);

  /// Disables the control and says why in its tool tip; an empty reason enables it.
  void setUnavailable(const QString& reason);

signals:
  void valueEdited(double value, const limn::Gesture& gesture);

private:
  void edit(double value, std::uint64_t gestureId);

  NumberSpec m_spec;
  ResetLabel* m_label;
  TrackSlider* m_slider;
  NumberField* m_field;
};

/// A range: as one number, with two handles on the slider and a field for each end, the upper one below. The
/// ends do not pass each other: a typed end stops at the other. A double click on the name resets both.
class RangeSlider : public QWidget {
  Q_OBJECT

public:
  explicit RangeSlider(const NumberSpec& spec, QWidget* parent = nullptr);

  /// Other words and limits; the numbers stay.
  void setSpec(const NumberSpec& spec);

  void setRange(double lower, double upper);

  /// How far apart the two ends stay at least; 0 at first. What is typed beyond is refused.
  void setLeastApart(double apart);

  /// Disables the control and says why in its tool tip; an empty reason enables it.
  void setUnavailable(const QString& reason);

signals:
  void rangeEdited(double lower, double upper, const limn::Gesture& gesture);

private:
  void edit(double lower, double upper, std::uint64_t gestureId);
  /// Neither end can be typed beyond the other.
  void boundEnds();

  NumberSpec m_spec;
  ResetLabel* m_label;
  TrackSlider* m_slider;
  NumberField* m_lower;
  NumberField* m_upper;
  double m_apart = 0.0;
};

} // namespace limn
