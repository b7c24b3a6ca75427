// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/presets/LookReport.h"
#include "app/presets/PresetStore.h"
#include "io/looks/Look.h"

namespace limn {

/// What became of files that were imported.
struct LookImport {
  std::vector<LookReportEntry> files;
  QStringList presets; ///< by what they are called now
};

/// Makes presets of the user's own from files. Nothing that the user has is replaced, what is there already
/// is not kept twice, and a file that cannot be read or kept does not keep others from it. Without a target a
/// look over fractions of a volume's range is refused: a list of presets is no place for what shows nothing
/// anywhere.
LookImport importLooks(const QStringList& paths, const std::optional<LookTarget>& target,
                       const PresetStore& store);

} // namespace limn
