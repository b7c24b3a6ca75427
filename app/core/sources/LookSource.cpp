// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/LookSource.h"

#include "scene/basics/Error.h"

#include <algorithm>

namespace limn {
namespace {

namespace fs = std::filesystem;

// The look with its series in a folder that nobody doubts.
PlacedLook placedIn(const fs::path& folder, DicomLook look, const std::string& name,
                    const Progress& progress) {
  const auto dicom = dicomAt(folder, progress);
  const int series =
      seriesOf(look, dicom ? dicom->images() : std::vector<SeriesImages>(), name, folder).number;
  return {std::move(look), dicom, series};
}

struct FoundLook {
  fs::path file;
  DicomLook look;
};

std::optional<FoundLook> lookIn(const fs::path& file) {
  try {
    if (isDicomLookFile(file))
      return FoundLook{file, readDicomLook(file)};
  } catch (const Error&) { // damaged, or one that cannot be drawn: nothing to offer
  }
  return std::nullopt;
}

// The presentation states beside a series; those in the folder of a single file are still to be found.
std::vector<fs::path> statesBeside(const DicomFolder& dicom, const Progress& progress) {
  if (fs::is_directory(dicom.path()))
    return dicom.states();
  const auto folder = openDicom(fs::absolute(dicom.path()).parent_path(), progress);
  return folder ? folder->states() : std::vector<fs::path>();
}

} // namespace

PlacedLook placedLook(const fs::path& file, const SourceOptions& options, const Progress& progress) {
  const std::string name = file.filename().string();
  DicomLook look = readDicomLook(file);
  if (options.volume)
    return placedIn(*options.volume, std::move(look), name, progress);
  std::vector<fs::path> places{fs::absolute(file).parent_path()};
  places.insert(places.end(), options.knownVolumes.begin(), options.knownVolumes.end());
  for (const fs::path& place : places)
    try {
      return placedIn(place, look, name, progress);
    } catch (const Error&) { // it does not hold the images, or cannot be read
    }
  throw VolumeMissing(
      places.front(), NamedBy::look,
      Message::tr("The series that the look %1 belongs to is not beside it; say where it is (--volume PATH).")
          .arg(name));
}

std::vector<fs::path> looksBeside(const DicomFolder& dicom, std::optional<int> series,
                                  const Progress& progress) {
  std::vector<FoundLook> looks;
  for (const fs::path& state : statesBeside(dicom, progress))
    if (auto look = lookIn(state))
      looks.push_back(std::move(*look));
  if (looks.empty())
    return {}; // as most often
  const std::vector<SeriesImages> all = dicom.images();
  const auto shown = static_cast<std::size_t>(series.value_or(1));
  std::vector<fs::path> files;
  for (const FoundLook& found : looks)
    if (shown >= 1 && shown <= all.size() && belongsToOne(found.look, {all[shown - 1]}))
      files.push_back(found.file);
  std::error_code unknown;
  std::ranges::stable_sort(files, std::ranges::greater(),
                           [&](const fs::path& file) { return fs::last_write_time(file, unknown); });
  return files;
}

} // namespace limn
