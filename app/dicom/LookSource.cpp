// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom/LookSource.h"

#include "scene/basics/Error.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

// Whether a folder that nobody named holds the images; one that cannot be read does not.
std::optional<int> seriesWithin(const fs::path& folder, const DicomLook& look, const std::string& name,
                                const Progress& progress) {
  try {
    return seriesOf(look, imagesUnder(folder, progress), name, folder).number;
  } catch (const Error&) {
    return std::nullopt;
  }
}

} // namespace

PlacedLook placedLook(const fs::path& file, const SourceOptions& options, const Progress& progress) {
  const std::string name = file.filename().string();
  PlacedLook placed{readDicomLook(file), {}, 1};
  if (options.volume) {
    placed.folder = *options.volume;
    placed.series = seriesOf(placed.look, imagesUnder(placed.folder, progress), name, placed.folder).number;
    return placed;
  }
  std::vector<fs::path> places{fs::absolute(file).parent_path()};
  places.insert(places.end(), options.knownVolumes.begin(), options.knownVolumes.end());
  for (const fs::path& place : places)
    if (const auto series = seriesWithin(place, placed.look, name, progress)) {
      placed.folder = place;
      placed.series = *series;
      return placed;
    }
  throw VolumeMissing(
      places.front(),
      Message::tr("The series that the look %1 belongs to is not beside it; say where it is (--volume PATH).")
          .arg(name));
}

} // namespace limn
