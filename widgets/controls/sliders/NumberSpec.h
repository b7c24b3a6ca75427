// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/sliders/SliderScale.h"

#include <QString>

namespace limn {

/// What a slider row says and allows.
struct NumberSpec {
  QString label;                  ///< a clinician's words, the formula's symbol in brackets
  QString help;                   ///< one sentence: what it does to the picture
  QString unit = {};              ///< empty where the number has none
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

/// What undo shows: "change ambient light".
QString changeText(const QString& label);

} // namespace limn
