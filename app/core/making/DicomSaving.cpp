// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/making/DicomSaving.h"

#include "io/AtomicFile.h"
#include "scene/basics/Error.h"

namespace limn {

SeriesImages shownSeries(const std::string& volumePath, std::shared_ptr<const DicomFolder> dicom,
                         std::optional<int> series, const Progress& progress) {
  if (!dicom)
    dicom = openDicom(volumePath, progress);
  if (dicom) {
    const std::vector<SeriesImages> all = dicom->images();
    const auto number = static_cast<std::size_t>(series.value_or(1));
    if (number >= 1 && number <= all.size())
      return all[number - 1];
  }
  throw Error(
      Error::Kind::usage,
      Message::tr("Only a DICOM series, or a scene of one, can be saved to DICOM, because picture and "
                  "look are filed with its patient and study; open the series that %1 was made from.")
          .arg(std::filesystem::path(volumePath).filename().string()));
}

// The folder that was meant is named, whichever above it takes none.
[[noreturn]] static void failMaking(const std::filesystem::path& folder, const Message& why) {
  throw Error(
      Error::Kind::other,
      Message::tr("The folder %1 cannot be made (%2); choose another one.").arg(folder.string()).arg(why));
}

void requireDicomFolder(const std::filesystem::path& folder) {
  std::error_code unknown;
  std::filesystem::path there = std::filesystem::current_path() / folder; // also where none is named
  if (std::filesystem::is_directory(there, unknown))
    return requireWritable(folder / "look.dcm");
  while (!std::filesystem::exists(there, unknown) && there.has_relative_path())
    there = there.parent_path();
  try {
    const ScratchFolder removedAtOnce(there);
  } catch (const Error& error) {
    failMaking(folder, error.sentence());
  }
}

std::vector<Message> saveToDicom(const std::filesystem::path& folder, const Scene& scene,
                                 const Image& picture, const SeriesImages& series, bool isAnonymous,
                                 const std::string& remark) {
  const DicomObjects objects =
      dicomObjectsOf(scene, {series, bytesOverBackground(picture, scene.image.background), LIMN_VERSION,
                             remark, isAnonymous});
  if (const Message why = makeFolders(folder); !why.empty())
    failMaking(folder, why);
  writeDicomObjects(folder, objects);
  return objects.losses;
}

} // namespace limn
