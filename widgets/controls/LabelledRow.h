// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Gesture.h"

#include <QLabel>
#include <QMouseEvent>
#include <QString>

namespace limn {

/// How a slider's track maps to numbers: 0 at its left end, 1 at its right; logarithmic where ratios matter.
struct SliderScale {
  double lowest = 0.0; ///< > 0 where logarithmic
  double highest = 1.0;
  bool logarithmic = false;
};

/// The place of a number on the track, limited to 0..1.
double fractionOf(const SliderScale& scale, double value);

/// The number at a place on the track; exact at both ends.
double valueAtFraction(const SliderScale& scale, double fraction);

/// A second unit of a number.
struct OtherUnit {
  QString unit = {};   ///< empty: none
  double factor = 1.0; ///< so many of the first are one of it
};

/// What a slider row says and allows.
struct NumberSpec {
  QString label;                  ///< a clinician's words, the formula's symbol in brackets
  QString called = {};            ///< what undo calls the number; empty: by its label
  QString help;                   ///< one sentence: what it does to the picture
  QString unit = {};              ///< empty where the number has none
  QString unitOfOne = {};         ///< behind 1, where it has another word there: "voxel"; empty: the same
  OtherUnit otherUnit = {};       ///< that can be typed, too
  SliderScale scale;              ///< of the track
  double lowest = scale.lowest;   ///< smallest number that can be typed
  double highest = scale.highest; ///< largest number that can be typed
  double defaultValue = 0.0;      ///< of a single number, or of a range's first
  double defaultUpper = 0.0;      ///< of a range's second
  int decimals = 2;
  QString lowerName = {}; ///< of a range's first number, for those who cannot see the control; empty: "from"
  QString upperName = {}; ///< of its second; empty: "to"
};

/// The tool tip of a row: the help, then range and default (`isRange`: both defaults), then how to reset.
QString toolTipOf(const NumberSpec& spec, bool isRange);

/// What assistive technology says of a slider beside its name: the unit, then the help.
QString describedFor(const NumberSpec& spec);

/// The unit behind a number, as it is written with the row's decimals.
QString unitBehind(const NumberSpec& spec, double number);

/// What undo shows: "change ambient light".
QString changeText(const QString& label);
/// The same of a number.
QString changeText(const NumberSpec& spec);
/// What is switched on or off by `label`: "light both sides: on".
Gesture switchGesture(const QString& label, bool isOn);
/// One of a few is chosen: "fog: None → Linear".
Gesture choiceGesture(const QString& label, const QString& before, const QString& after);

/// How wide the names in a panel are: behind them tracks and boxes begin, all at one place.
inline constexpr int labelColumn = 116;

/// The name of a control; a double click asks for the default.
class ResetLabel : public QLabel {
  Q_OBJECT

public:
  using QLabel::QLabel;

signals:
  void resetRequested();

protected:
  void mouseDoubleClickEvent(QMouseEvent* event) override {
    if (event->button() == Qt::LeftButton)
      emit resetRequested();
  }
};

} // namespace limn
