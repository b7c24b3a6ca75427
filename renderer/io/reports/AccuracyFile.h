// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace limn {

struct AccuracyReport;

/// Reads the text that accuracyJson (ReportJson.h) wrote: scene, machine, renderer, size, the exact picture
/// and the points; what each decision costs stays behind. Where the exact picture did not converge, errors
/// are 0. `name` is how errors call it. Throws Error (input), naming the field.
AccuracyReport parseAccuracy(std::string_view text, const std::string& name);

} // namespace limn
