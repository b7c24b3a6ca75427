// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace limn::test {

/// What must be found nowhere: every form in which the marked series names its patient.
const std::vector<std::string>& patientMarks();

/// Writes `slices` DICOM files of 24 × 20 pixels whose every personal attribute carries a mark.
void writeMarkedSeries(const std::filesystem::path& folder, int slices = 16);

/// The marks found in these bytes, in UTF-8 or UTF-16 of either order, upper and lower case alike; also
/// inside zlib and gzip streams and base64 (compressed text in PNG, EXR and TIFF, pictures inside pages), and
/// in what those contain. `searched` grows by the bytes looked at.
std::set<std::string> marksIn(const std::string& bytes, std::size_t& searched);

} // namespace limn::test
