// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom/LooksBeside.h"

#include "io/dicom/DicomImages.h"
#include "io/looks/dicom/DicomLook.h"
#include "scene/basics/Error.h"

#include <algorithm>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostFilesLookedAt = 20000; // a folder of more is no series

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

std::vector<FoundLook> looksUnder(const fs::path& folder, const Progress& progress) {
  std::vector<FoundLook> found;
  std::error_code failure;
  std::size_t count = 0;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    if (++count > mostFilesLookedAt)
      break;
    if (progress.isCancelled && progress.isCancelled())
      throw Cancelled();
    if (auto look = lookIn(entry->path()))
      found.push_back(std::move(*look));
  }
  return found;
}

} // namespace

std::vector<fs::path> looksBeside(const fs::path& volume, std::optional<int> series,
                                  const Progress& progress) {
  const fs::path folder = fs::is_directory(volume) ? volume : volume.parent_path();
  const std::vector<FoundLook> looks = looksUnder(folder, progress);
  if (looks.empty())
    return {}; // as most often: the headers are not read again
  const std::vector<SeriesImages> all = imagesUnder(volume, progress);
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
