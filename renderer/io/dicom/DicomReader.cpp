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

std::string listed(const SeriesSummary& summary) {
  std::string text = std::to_string(summary.number) + " (" + summary.modality;
  if (!summary.description.empty())
    text += " '" + summary.description + "'";
  return text + ", " + std::to_string(summary.dims.x) + " × " + std::to_string(summary.dims.y) + ", " +
         std::to_string(summary.dims.z) + (summary.dims.z == 1 ? " image)" : " images)");
}

std::string listed(const std::vector<DicomSeries>& all, std::size_t except) {
  constexpr std::size_t mostNamed = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), mostNamed); ++i)
    if (i != except)
      text += (text.empty() ? "" : ", ") + listed(summaryOf(all[i], static_cast<int>(i) + 1));
  if (all.size() > mostNamed)
    text += " and " + std::to_string(all.size() - mostNamed) + " more";
  return text;
}

DicomSeries chosenSeries(const std::filesystem::path& path, const std::vector<DicomSeries>& all,
                         const ReadOptions& options, std::vector<std::string>& warnings) {
  const int count = static_cast<int>(all.size());
  if (options.series && (*options.series < 1 || *options.series > count))
    throw Error(Error::Kind::input, nameOf(path) + " has no series " + std::to_string(*options.series) +
                                        "; it holds " + listed(all, all.size()) + ".");
  const auto index = static_cast<std::size_t>(options.series.value_or(1) - 1);
  if (!options.series && count > 1)
    warnings.push_back(std::to_string(count) + " series were found and the largest is shown, " +
                       listed(summaryOf(all[0], 1)) + "; the others are " + listed(all, 0) +
                       ". Choose one by its number.");
  return all[index];
}

// The first three of several names.
std::string firstNames(const std::vector<std::string>& files) {
  constexpr std::size_t mostNamed = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(files.size(), mostNamed); ++i)
    text += (text.empty() ? "" : ", ") + plainText(files[i], 80);
  if (files.size() > mostNamed)
    text += " and " + std::to_string(files.size() - mostNamed) + " more";
  return text;
}

void noteScan(const std::filesystem::path& path, const DicomScan& scan, std::vector<std::string>& warnings) {
  const std::size_t damaged = scan.damaged.size();
  if (damaged > 0)
    warnings.push_back(std::to_string(damaged) + " DICOM " +
                       (damaged == 1 ? "file is damaged or cut off and was left out ("
                                     : "files are damaged or cut off and were left out (") +
                       firstNames(scan.damaged) + "): slices may be missing; copy the series again.");
  const bool isOneImage = !std::filesystem::is_directory(path) && scan.images.size() == 1 &&
                          scan.images.front().frames.size() == 1;
  if (isOneImage)
    warnings.emplace_back("This is a single image; open its folder to see the whole series.");
}

void requireImages(const std::filesystem::path& path, const DicomScan& scan) {
  if (!scan.images.empty())
    return;
  std::string found = "no DICOM files";
  if (scan.withoutImage > 0)
    found = "DICOM objects without images only (reports, plans or indices)";
  if (!scan.damaged.empty())
    found = "only DICOM files that are damaged or cut off (" + firstNames(scan.damaged) + ")";
  throw Error(Error::Kind::input,
              "The folder " + nameOf(path) + " holds " + found + "; choose the folder of an image series.");
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
    throw Error(Error::Kind::input, nameOf(path) + " makes a volume of " + std::to_string(dims.x) + " × " +
                                        std::to_string(dims.y) + " × " + std::to_string(dims.z) +
                                        " voxels, more than can be shown; choose a smaller series.");
  requireMemory(path, static_cast<double>(dims.x) * dims.y * dims.z);
}

void applySpacing(const ReadOptions& options, DicomGeometry& geometry) {
  if (!options.spacingMm)
    return;
  geometry.grid.spacingMm = *options.spacingMm;
  geometry.spacingKnown = true;
}

VolumeInfo infoOf(const DicomSeries& series, const DicomGeometry& geometry,
                  const std::vector<std::string>& warnings) {
  const DicomHeader& first = *series.front().header;
  VolumeInfo info;
  info.format = "DICOM";
  info.modality = first.modality;
  info.unit = first.unit;
  info.hints = first.hints;
  info.orientationKnown = geometry.orientationKnown;
  info.spacingKnown = geometry.spacingKnown;
  for (const std::string& warning : warnings)
    info.warnings.push_back(plainText(warning));
  info.patient = first.patient;
  return info;
}

std::shared_ptr<const Volume> volumeOf(const std::filesystem::path& path, const DicomSeries& series,
                                       const ReadOptions& options, const Progress& progress,
                                       std::vector<std::string> warnings) {
  DicomGeometry geometry =
      naming(path, [&] { return geometryOf(series, options.spacingMm.has_value(), warnings); });
  const DicomHeader& first = *series.front().header;
  const glm::ivec3 sourceDims(first.columns, first.rows, static_cast<int>(series.size()));
  requireRoom(path, glm::max(sourceDims, geometry.grid.dims));
  DicomVoxels voxels =
      readVoxels(series, part(progress, 0.3, geometry.needsResampling ? 0.75 : 0.95), warnings);
  if (geometry.needsResampling)
    voxels = resampled(std::move(voxels), sourceDims, geometry, part(progress, 0.75, 0.95));
  applySpacing(options, geometry);
  requirePlausible(path, geometry.grid);
  return naming(path, [&] {
    return std::make_shared<const Volume>(geometry.grid, std::move(voxels.stored), voxels.rescale,
                                          voxels.padding, infoOf(series, geometry, warnings),
                                          effortOf(part(progress, 0.95, 1.0), countingVoxels));
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
  std::vector<std::string> warnings;
  noteScan(path, scan, warnings);
  DicomSeries series = sorted(chosenSeries(path, seriesOf(scan.images), options, warnings));
  series = withoutCopies(std::move(series), warnings);
  if (isPlaced(series))
    series = onePhase(series, warnings);
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
