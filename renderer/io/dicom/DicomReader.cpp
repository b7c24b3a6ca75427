// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomReader.h"

#include "io/dicom/DicomVoxels.h"
#include "io/dicom/series/DicomGeometry.h"
#include "io/dicom/series/DicomScan.h"
#include "io/dicom/series/DicomSeries.h"
#include "io/reading/Bounds.h"
#include "io/reading/ReadError.h"

#include <algorithm>

namespace limn {
namespace {

constexpr std::size_t mostFilesLookedAt = 2000;
constexpr double mostVoxels = 4e9;

std::string nameOf(const std::filesystem::path& path) {
  return path.has_filename() ? path.filename().string() : path.string();
}

Message listed(const SeriesSummary& summary) {
  std::string name = summary.modality;
  if (!summary.description.empty())
    name += " '" + summary.description + "'";
  return (summary.dims.z == 1 ? Message::tr("%1 (%2, %3 × %4, %5 image)")
                              : Message::tr("%1 (%2, %3 × %4, %5 images)"))
      .arg(summary.number)
      .arg(name)
      .arg(summary.dims.x)
      .arg(summary.dims.y)
      .arg(summary.dims.z);
}

Message listed(const std::vector<DicomSeries>& all, std::size_t except) {
  constexpr std::size_t mostNamed = 8;
  Message list;
  for (std::size_t i = 0; i < std::min(all.size(), mostNamed); ++i)
    if (i != except)
      list = list.followedBy(", ", listed(summaryOf(all[i], static_cast<int>(i) + 1)));
  return all.size() > mostNamed ? Message::tr("%1 and %2 more").arg(list).arg(all.size() - mostNamed) : list;
}

DicomSeries chosenSeries(const std::filesystem::path& path, const std::vector<DicomSeries>& all,
                         const ReadOptions& options, std::vector<Message>& warnings) {
  const int count = static_cast<int>(all.size());
  if (options.series && (*options.series < 1 || *options.series > count))
    throw Error(Error::Kind::input, Message::tr("%1 has no series %2; it holds %3.")
                                        .arg(nameOf(path))
                                        .arg(*options.series)
                                        .arg(listed(all, all.size())));
  const auto index = static_cast<std::size_t>(options.series.value_or(1) - 1);
  if (!options.series && count > 1)
    warnings.push_back(
        Message::tr(
            "%1 series were found and the largest is shown, %2; the others are %3. Choose one by its number.")
            .arg(count)
            .arg(listed(summaryOf(all[0], 1)))
            .arg(listed(all, 0)));
  return all[index];
}

// The first three of several names.
Message firstNames(const std::vector<std::string>& files) {
  constexpr std::size_t mostNamed = 3;
  Message list;
  for (std::size_t i = 0; i < std::min(files.size(), mostNamed); ++i)
    list = list.followedBy(", ", plainText(files[i], 80));
  return files.size() > mostNamed ? Message::tr("%1 and %2 more").arg(list).arg(files.size() - mostNamed)
                                  : list;
}

void noteScan(const std::filesystem::path& path, const DicomScan& scan, std::vector<Message>& warnings) {
  const std::size_t damaged = scan.damaged.size();
  if (damaged > 0)
    warnings.push_back((damaged == 1 ? Message::tr("%1 DICOM file is damaged or cut off and was left out "
                                                   "(%2): slices may be missing; copy the series again.")
                                     : Message::tr("%1 DICOM files are damaged or cut off and were left out "
                                                   "(%2): slices may be missing; copy the series again."))
                           .arg(damaged)
                           .arg(firstNames(scan.damaged)));
  const bool isOneImage = !std::filesystem::is_directory(path) && scan.images.size() == 1 &&
                          scan.images.front().frames.size() == 1;
  if (isOneImage)
    warnings.emplace_back(Message::tr("This is a single image; open its folder to see the whole series."));
}

void requireImages(const std::filesystem::path& path, const DicomScan& scan) {
  if (!scan.images.empty())
    return;
  Message found = Message::tr("no DICOM files");
  if (scan.withoutImage > 0)
    found = Message::tr("DICOM objects without images only (reports, plans or indices)");
  if (!scan.damaged.empty())
    found = Message::tr("only DICOM files that are damaged or cut off (%1)").arg(firstNames(scan.damaged));
  throw Error(Error::Kind::input, Message::tr("The folder %1 holds %2; choose the folder of an image series.")
                                      .arg(nameOf(path))
                                      .arg(found));
}

void requireSeries(const DicomSeries& series) {
  const DicomHeader* checked = nullptr;
  for (const DicomSlice& slice : series) {
    if (slice.header == checked)
      continue;
    checked = slice.header;
    requireSupported(*checked);
    requireWhole(*checked);
  }
}

void requireRoom(const std::filesystem::path& path, const glm::ivec3& dims) {
  if (static_cast<double>(dims.x) * dims.y * dims.z > mostVoxels)
    throw Error(
        Error::Kind::input,
        Message::tr(
            "%1 makes a volume of %2 × %3 × %4 voxels, more than can be shown; choose a smaller series.")
            .arg(nameOf(path))
            .arg(dims.x)
            .arg(dims.y)
            .arg(dims.z));
}

void applySpacing(const ReadOptions& options, DicomGeometry& geometry) {
  if (!options.spacingMm)
    return;
  geometry.grid.spacingMm = *options.spacingMm;
  geometry.spacingKnown = true;
}

VolumeInfo infoOf(const DicomSeries& series, const DicomGeometry& geometry,
                  const std::vector<Message>& warnings) {
  const DicomHeader& first = *series.front().header;
  VolumeInfo info;
  info.format = "DICOM";
  info.modality = first.modality;
  info.unit = first.unit;
  info.hints = first.hints;
  info.orientationKnown = geometry.orientationKnown;
  info.spacingKnown = geometry.spacingKnown;
  for (const Message& warning : warnings)
    info.warnings.push_back(plainMessage(warning));
  info.patient = first.patient;
  return info;
}

std::shared_ptr<const Volume> volumeOf(const std::filesystem::path& path, const DicomSeries& series,
                                       const ReadOptions& options, const Progress& progress,
                                       std::vector<Message> warnings) {
  DicomGeometry geometry =
      naming(path, [&] { return geometryOf(series, options.spacingMm.has_value(), warnings); });
  const DicomHeader& first = *series.front().header;
  const glm::ivec3 sourceDims(first.columns, first.rows, static_cast<int>(series.size()));
  requireRoom(path, glm::max(sourceDims, geometry.grid.dims));
  const DicomKeeping keeping{path, options.memory.value_or(MemoryBudget()), geometry.needsResampling};
  DicomVoxels voxels =
      readVoxels(series, keeping, part(progress, 0.3, geometry.needsResampling ? 0.75 : 0.95), warnings);
  if (geometry.needsResampling)
    voxels =
        resampled(std::move(voxels), sourceDims, geometry, keeping, part(progress, 0.75, 0.95), warnings);
  applySpacing(options, geometry);
  requirePlausible(path, geometry.grid);
  return naming(path, [&] {
    return std::make_shared<const Volume>(geometry.grid, storedVoxels(std::move(voxels.stored)),
                                          voxels.rescale, voxels.padding, infoOf(series, geometry, warnings),
                                          effortOf(part(progress, 0.95, 1.0), countingVoxels), voxels.room);
  });
}

} // namespace

bool isDicom(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error))
    return startsAsDicom(path);
  if (!std::filesystem::is_directory(path, error) || isPseudoFolder(path))
    return false;
  std::filesystem::recursive_directory_iterator entry(
      path, std::filesystem::directory_options::skip_permission_denied, error);
  std::size_t looked = 0;
  for (; !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && isPseudoFolder(entry->path()))
      entry.disable_recursion_pending();
    if (entry->is_regular_file(ignored) && startsAsDicom(entry->path()))
      return true;
    if (++looked > mostFilesLookedAt)
      return false;
  }
  return false;
}

std::shared_ptr<const Volume> readDicom(const std::filesystem::path& path, const ReadOptions& options,
                                        const Progress& progress) {
  const DicomScan scan = scanDicom(path, part(progress, 0.0, 0.3));
  requireImages(path, scan);
  std::vector<Message> warnings;
  noteScan(path, scan, warnings);
  const DicomSeries series = shownOf(chosenSeries(path, seriesOf(scan.images), options, warnings), warnings);
  requireSeries(series);
  return volumeOf(path, series, options, progress, std::move(warnings));
}

std::vector<SeriesSummary> listDicomSeries(const std::filesystem::path& path) {
  if (!isDicom(path))
    return {};
  const DicomScan scan = scanDicom(path, {});
  std::vector<SeriesSummary> summaries;
  for (const DicomSeries& series : seriesOf(scan.images))
    if (series.front().header->pixels) {
      summaries.push_back(summaryOf(series, static_cast<int>(summaries.size()) + 1));
      const auto folder = series.front().header->path.parent_path().lexically_relative(path);
      summaries.back().folder = folder == "." ? std::string() : folder.generic_string();
    }
  return summaries;
}

} // namespace limn
