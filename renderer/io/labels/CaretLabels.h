// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"

#include <string>
#include <vector>

namespace limn {

/// Names and colours of labels in a table as Caret and Connectome Workbench keep it in XML, and
/// TotalSegmentator in the extension of a NIfTI file: CaretExtension ▸ … ▸ LabelTable ▸ Label with Key, Red,
/// Green, Blue (0..1) and the name as its text. Entries without a sound key, and the background (0), are left
/// out; none where the bytes are something else. Zeros may follow.
std::vector<Label> caretLabels(const std::string& bytes);

} // namespace limn
