// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/MaskFolder.h"

#include "io/VolumeReader.h"
#include "io/labels/LabelNames.h"
#include "io/reading/ReadError.h"
#include "regions/LabelsOnGrid.h"

#include <algorithm>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestMaskName = 200;
constexpr std::size_t mostNamed = 3;

// What a mask is called among others: by its structure, where that is its alone, or by its whole name, unless
// that may name the patient.
std::string maskName(const fs::path& file, int value, const std::vector<fs::path>& files,
                     const PatientLabel& patient) {
  const auto structureOf = [&](const fs::path& one) { return structureName(one, patient); };
  const std::string structure = structureOf(file), stem = volumeStem(file);
  if (!structure.empty() && std::ranges::count(files, structure, structureOf) == 1)
    return structure;
  return withoutPatient(stem, patient) == stem ? plainText(stem, longestMaskName)
                                               : "Label " + std::to_string(value);
}

// The files of a folder by name; hidden ones are none of the user's.
std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.'))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Message listOf(const std::vector<std::string>& names) {
  Message list;
  for (std::size_t n = 0; n < std::min(names.size(), mostNamed); ++n)
    list = list.followedBy(", ", plainText(names[n], longestMaskName));
  return names.size() > mostNamed ? Message::tr("%1 and %2 more").arg(list, names.size() - mostNamed) : list;
}

// Whether masks come by name, as those of a folder, or in the order in which they were chosen.
enum class Order { byName, asChosen };

Message overlapIn(const MasksOnGrid& masks, Order order) {
  const auto& largest = masks.largestOverlap();
  if (!largest)
    return {};
  if (largest->voxels == masks.overlapping())
    return (order == Order::byName
                ? Message::tr("%1 voxels lie in two masks and belong to the one whose name comes last: to %2 "
                              "and not to %3.")
                : Message::tr("%1 voxels lie in two masks and belong to the one that was opened last: to %2 "
                              "and not to %3."))
        .arg(largest->voxels, largest->winner, largest->loser);
  return (order == Order::byName
              ? Message::tr("%1 voxels lie in more than one mask and belong to the one whose name comes "
                            "last; most of them, %2, to %3 and not to %4.")
              : Message::tr("%1 voxels lie in more than one mask and belong to the one that was opened "
                            "last; most of them, %2, to %3 and not to %4."))
      .arg(masks.overlapping(), largest->voxels, largest->winner, largest->loser);
}

Message leftOutOf(const std::vector<std::string>& skipped) {
  if (skipped.empty())
    return {};
  return skipped.size() == 1 ? Message::tr("%1 is no mask and was left out.").arg(listOf(skipped))
                             : Message::tr("%1 files are no masks and were left out: %2.")
                                   .arg(skipped.size(), listOf(skipped));
}

} // namespace

bool isMaskFolder(const fs::path& path) {
  try {
    const std::vector<fs::path> files = fs::is_directory(path) ? filesIn(path) : std::vector<fs::path>();
    return std::any_of(files.begin(), files.end(),
                       [](const fs::path& file) { return !volumeStem(file).empty(); });
  } catch (const fs::filesystem_error&) {
    return false;
  }
}

namespace {

// Masks on a grid, and of which files they are; none where no file is one.
struct ReadMasks {
  std::optional<MasksOnGrid> masks{};
  std::vector<fs::path> files{};
  std::vector<std::string> skipped{};
};

ReadMasks readInOrder(const std::vector<fs::path>& files, Order order, const Grid& grid,
                      const Progress& progress, const PatientLabel& patient) {
  ReadMasks read;
  int value = 0;
  for (std::size_t n = 0; n < files.size(); ++n) {
    const bool isVolume = !volumeStem(files[n]).empty();
    const auto share = [&](double done) {
      return (static_cast<double>(n) + done) / static_cast<double>(files.size());
    };
    const auto mask = isVolume ? readVolume(files[n], {}, part(progress, share(0.0), share(0.8))) : nullptr;
    const bool isTaken = mask && isMask(*mask);
    // A folder's numbers hold whatever its files hold; of others those that are no masks are left out for
    // good.
    value += (order == Order::byName ? isVolume : isTaken) ? 1 : 0;
    if (!isTaken) {
      read.skipped.push_back(files[n].filename().string());
      continue;
    }
    requireNear(files[n], mask->grid(), grid);
    if (!read.masks)
      read.masks.emplace(grid, files.size(), mask->room());
    read.files.push_back(files[n]);
    read.masks->add(*mask, value, maskName(files[n], value, files, patient),
                    effortOf(part(progress, share(0.8), share(1.0)), Message::tr("Placing labels")));
  }
  return read;
}

Region regionOf(MasksOnGrid& masks, const std::string& source) {
  const auto map = masks.finished();
  return {Region::Kind::labels, source, map, std::vector<double>(map->labels().size(), 1.0)};
}

} // namespace

Segmentation readMaskFolder(const fs::path& folder, const Grid& grid, const Progress& progress,
                            const PatientLabel& patient) {
  ReadMasks read = readInOrder(filesIn(folder), Order::byName, grid, progress, patient);
  if (!read.masks)
    failReading(folder, Message::tr("no file in it is the mask of a structure: 0, and one value inside"),
                Message::tr("open the folder that the segmentation was written to"));
  const Message remark = leftOutOf(read.skipped).followedBy(" ", overlapIn(*read.masks, Order::byName));
  const Region region = regionOf(*read.masks, sourceOf(folder));
  if (region.weights.size() == 1)
    failReading(folder, Message::tr("all of its masks are empty"),
                Message::tr("open the segmentation of this volume"));
  return {region, remark};
}

Segmentation readMasks(const std::vector<fs::path>& files, const Grid& grid, const Progress& progress,
                       const PatientLabel& patient) {
  ReadMasks read = readInOrder(files, Order::asChosen, grid, progress, patient);
  if (!read.masks)
    failReading(files.front(),
                Message::tr("neither it nor another file that was chosen is the mask of a structure: 0, and "
                            "one value inside"),
                Message::tr("open a file of several labels by itself"));
  const Message leftOut = leftOutOf(read.skipped);
  const Message remark = leftOut.followedBy(" ", overlapIn(*read.masks, Order::asChosen));
  Region region = regionOf(*read.masks, sourceOf(read.files.front()));
  if (region.weights.size() == 1)
    failReading(files.front(), Message::tr("it and the other masks that were chosen are empty"),
                Message::tr("open the segmentation of this volume"));
  if (read.files.size() == 1) // with the number that its file gives it, as it is read again
    return {readSegmentation(read.files.front(), grid, progress, patient).region, remark, leftOut};
  for (std::size_t n = 1; n < read.files.size(); ++n)
    region.moreSources.push_back(sourceOf(read.files[n]));
  return {region, remark, leftOut};
}

} // namespace limn
