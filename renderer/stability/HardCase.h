// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/Finding.h"

#include <functional>
#include <string>
#include <vector>

namespace limn {

class Workbench;

/// A situation in which volume renderers are known to fail, as a scene or an input with a bound: a row of
/// the report for each renderer that can draw it, and for each of the settings that it names.
struct HardCase {
  std::string id;    ///< "H1", stable from version to version
  std::string title; ///< the situation and what must hold, for people
  std::vector<Finding> (*measure)(Workbench& bench);
};

/// What was measured of a case.
struct MeasuredCase {
  std::string id;
  std::string title;
  std::vector<Finding> findings;
};

/// Told how far long work is, 0..1, and what it does; throws Cancelled to end it.
using ReportStability = std::function<void(double fraction, const std::string& doing)>;

/// Measures cases one after the other. A case that ends with an error has failed, with the error's sentence;
/// Cancelled passes through.
std::vector<MeasuredCase> measure(const std::vector<HardCase>& cases, Workbench& bench,
                                  const ReportStability& report = {});

/// Whether no finding of any case failed.
bool allHold(const std::vector<MeasuredCase>& cases);

} // namespace limn
