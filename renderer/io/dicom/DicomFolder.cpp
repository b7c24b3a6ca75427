// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomFolder.h"

#include "io/dicom/DicomVoxels.h"
#include "io/dicom/series/DicomGeometry.h"
#include "io/reading/Bounds.h"
#include "io/reading/HeaderText.h"
#include "io/reading/PartOfVolume.h"
#include "io/reading/ReadError.h"

#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <set>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostFiles = 50000;
constexpr std::size_t mostForeign = 2000;
constexpr int deepestFolder = 8;
constexpr double headersShare = 0.3; // of the progress

const std::string dicomDirClass = "1.2.840.10008.1.3.10";
const std::string stateClasses = "1.2.840.10008.5.1.4.1.1.11.";

// Whether a folder shows the state of the kernel (/proc, /sys and the like) rather than files on a disk: its
// files announce lengths that they do not have, and reading some of them has effects.
bool isPseudoFolder(const fs::path& folder) {
  // Linux, include/uapi/linux/magic.h: proc, sysfs, debugfs, tracefs, cgroup, cgroup2, securityfs, selinuxfs,
  // bpf, configfs, pstore, efivarfs, binfmt_misc.
  constexpr std::array<unsigned, 13> magics = {0x9fa0,     0x62656572, 0x64626720, 0x74726163, 0x27e0eb,
                                               0x63677270, 0x73636673, 0xf97cff8c, 0xcafe4a11, 0x62656570,
                                               0x6165676c, 0xde5e81e4, 0x42494e4d};
  struct statfs facts {};
  return statfs(folder.c_str(), &facts) == 0 &&
         std::find(magics.begin(), magics.end(), static_cast<unsigned>(facts.f_type)) != magics.end();
}

// The regular files under a folder and its subfolders, sorted by path; one more than any study has where
// there are too many.
std::vector<fs::path> filesUnder(const fs::path& folder, const Progress& progress) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (progress.isCancelled && progress.isCancelled())
      throw Cancelled();
    std::error_code ignored;
    if (entry.depth() >= deepestFolder || (entry->is_directory(ignored) && isPseudoFolder(entry->path())))
      entry.disable_recursion_pending();
    if (entry->is_regular_file(ignored))
      files.push_back(entry->path());
    if (files.size() > mostFiles)
      break;
  }
  if (error)
    failReading(folder, error.message(), Message::tr("check the name and the right to read it"));
  std::ranges::sort(files);
  return files;
}

bool hasDicomEnding(const fs::path& path) {
  const std::string ending = path.extension().string();
  const std::string name = path.filename().string();
  return name.front() != '.' &&
         (ending == ".dcm" || ending == ".DCM" || ending == ".dicom" || ending == ".ima" || ending == ".IMA");
}

// What is known of the files of a folder while they are looked at.
struct Findings {
  DicomHeaders headers;
  std::vector<DicomHeader> withoutPicture;
  std::vector<fs::path> foreign; ///< they do not start as DICOM
  std::vector<fs::path> damaged;

  void look(const fs::path& path) {
    try {
      if (const auto file = parseIfDicom(path))
        add(headerOf(path, *file));
      else
        foreign.push_back(path);
    } catch (const Error&) {
      damaged.push_back(path);
    }
  }

  void add(DicomHeader header) {
    if (header.pixels)
      headers.images.push_back(std::move(header));
    else if (hasLostPicture(header))
      damaged.push_back(header.path);
    else
      withoutPicture.push_back(std::move(header));
  }
};

// What the images tell of the other files: which names slices have, and which kinds hold pictures.
DicomHeaders judged(Findings found) {
  NameLikeness names;
  std::set<std::string> classes;
  for (const DicomHeader& image : found.headers.images) {
    names.add(image.path);
    classes.insert(image.sopClass);
  }
  for (const DicomHeader& header : found.withoutPicture) {
    if (classes.contains(header.sopClass))
      found.damaged.push_back(header.path);
    else
      ++found.headers.withoutImage;
    if (header.sopClass.starts_with(stateClasses))
      found.headers.states.push_back(header.path);
  }
  for (const fs::path& file : found.foreign)
    if (names.isLike(file) || hasDicomEnding(file))
      found.damaged.push_back(file);
  std::ranges::sort(found.damaged);
  for (const fs::path& file : found.damaged)
    found.headers.damaged.push_back(file.filename().string());
  return std::move(found.headers);
}

std::optional<DicomHeaders> headersUnder(const fs::path& folder, const Progress& progress) {
  if (isPseudoFolder(folder))
    return std::nullopt;
  const std::vector<fs::path> files = filesUnder(folder, progress);
  Findings found;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const bool isForeign = found.foreign.size() == i;
    if (isForeign && i >= mostForeign)
      return std::nullopt;
    // Whoever reads a folder of something else reports that.
    const Progress told{isForeign && i > 0 ? nullptr : progress.report, progress.isCancelled};
    reportOrStop(told, static_cast<double>(i) / static_cast<double>(files.size()),
                 Message::tr("Reading headers"));
    found.look(files[i]);
    if (files.size() > mostFiles && found.foreign.size() <= i)
      throw Error(Error::Kind::input,
                  Message::tr("The folder %1 holds more than %2 files; open the folder of one study instead.")
                      .arg(folder.string(), mostFiles));
  }
  if (found.foreign.size() == files.size())
    return std::nullopt;
  return judged(std::move(found));
}

std::optional<DicomHeaders> headersAt(const fs::path& path, const Progress& progress) {
  std::error_code unknown;
  if (fs::is_directory(path, unknown))
    return headersUnder(path, progress);
  const auto file = fs::is_regular_file(path, unknown) ? parseIfDicom(path) : std::nullopt;
  if (!file)
    return std::nullopt;
  DicomHeaders headers;
  headers.images.push_back(headerOf(path, *file));
  if (headers.images.front().sopClass == dicomDirClass)
    return headersUnder(fs::absolute(path).parent_path(), progress);
  return headers;
}

constexpr double mostVoxels = 4e9;

std::string nameOf(const fs::path& path) {
  return path.has_filename() ? path.filename().string() : path.string();
}

Message listed(const SeriesSummary& summary) {
  std::string name = summary.modality;
  if (!summary.description.empty())
    name += " '" + summary.description + "'";
  return (summary.dims.z == 1 ? Message::tr("%1 (%2, %3 × %4, %5 image)")
                              : Message::tr("%1 (%2, %3 × %4, %5 images)"))
      .arg(summary.number, name, summary.dims.x, summary.dims.y, summary.dims.z);
}

Message listed(const std::vector<DicomSeries>& all, std::size_t except) {
  constexpr std::size_t mostNamed = 8;
  Message list;
  for (std::size_t i = 0; i < std::min(all.size(), mostNamed); ++i)
    if (i != except)
      list = list.followedBy(", ", listed(summaryOf(all[i], static_cast<int>(i) + 1)));
  return all.size() > mostNamed ? Message::tr("%1 and %2 more").arg(list, all.size() - mostNamed) : list;
}

DicomSeries chosenSeries(const fs::path& path, const std::vector<DicomSeries>& all,
                         const ReadOptions& options, std::vector<Message>& warnings) {
  const int count = static_cast<int>(all.size());
  if (options.series && (*options.series < 1 || *options.series > count))
    throw Error(Error::Kind::input, Message::tr("%1 has no series %2; it holds %3.")
                                        .arg(nameOf(path), *options.series, listed(all, all.size())));
  const auto index = static_cast<std::size_t>(options.series.value_or(1) - 1);
  if (!options.series && count > 1)
    warnings.push_back(
        Message::tr(
            "%1 series were found and the largest is shown, %2; the others are %3. Choose one by its number.")
            .arg(count, listed(summaryOf(all[0], 1)), listed(all, 0)));
  return all[index];
}

// The first three of several names.
Message firstNames(const std::vector<std::string>& files) {
  constexpr std::size_t mostNamed = 3;
  Message list;
  for (std::size_t i = 0; i < std::min(files.size(), mostNamed); ++i)
    list = list.followedBy(", ", plainText(files[i], 80));
  return files.size() > mostNamed ? Message::tr("%1 and %2 more").arg(list, files.size() - mostNamed) : list;
}

void noteFiles(const fs::path& path, const DicomHeaders& headers, std::vector<Message>& warnings) {
  const std::size_t damaged = headers.damaged.size();
  if (damaged > 0)
    warnings.push_back((damaged == 1 ? Message::tr("%1 DICOM file is damaged or cut off and was left out "
                                                   "(%2): slices may be missing; copy the series again.")
                                     : Message::tr("%1 DICOM files are damaged or cut off and were left out "
                                                   "(%2): slices may be missing; copy the series again."))
                           .arg(damaged, firstNames(headers.damaged)));
  const bool isOneImage =
      !fs::is_directory(path) && headers.images.size() == 1 && headers.images.front().frames.size() == 1;
  if (isOneImage)
    warnings.emplace_back(Message::tr("This is a single image; open its folder to see the whole series."));
}

void requireImages(const fs::path& path, const DicomHeaders& headers) {
  if (!headers.images.empty())
    return;
  Message found = Message::tr("DICOM objects without images only (reports, plans or indices)");
  if (!headers.damaged.empty())
    found = Message::tr("only DICOM files that are damaged or cut off (%1)").arg(firstNames(headers.damaged));
  throw Error(
      Error::Kind::input,
      Message::tr("The folder %1 holds %2; choose the folder of an image series.").arg(nameOf(path), found));
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

void requireRoom(const fs::path& path, const glm::ivec3& dims) {
  if (static_cast<double>(dims.x) * dims.y * dims.z > mostVoxels)
    throw Error(
        Error::Kind::input,
        Message::tr(
            "%1 makes a volume of %2 × %3 × %4 voxels, more than can be shown; choose a smaller series.")
            .arg(nameOf(path), dims.x, dims.y, dims.z));
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
  info.slants = geometry.slants;
  for (const Message& warning : warnings)
    info.warnings.push_back(plainMessage(warning));
  info.patient = first.patient;
  return info;
}

// The part of a series that this process holds. No slice is straightened.
std::shared_ptr<const Volume> partOfSeries(const fs::path& path, const DicomSeries& series,
                                           DicomGeometry geometry, const ReadOptions& options,
                                           const Progress& progress, std::vector<Message> warnings) {
  applySpacing(options, geometry);
  requirePlausible(path, geometry.grid);
  const PartWanted& wanted = *options.part;
  const PartWanted::Share share = wanted.share(geometry.grid, true);
  DicomVoxels voxels = readVoxels(series, {path, wanted.memory, false, share.held},
                                  part(progress, headersShare, 0.95), warnings);
  PartRead read;
  read.grid = geometry.grid;
  read.stored = storedVoxels(std::move(voxels.stored));
  read.rescale = voxels.rescale;
  read.padding = voxels.padding;
  read.info = infoOf(series, geometry, warnings);
  read.room = voxels.room;
  read.held = share.held;
  read.own = share.own;
  read.isInSlices = true;
  read.bitsIgnored = voxels.bitsIgnored;
  const auto again = [path](const ReadOptions& other) { return openDicom(path, {})->read(other, {}); };
  return naming(path, [&] {
    return volumeOfPart(std::move(read), options, again, effortOf(part(progress, 0.95, 1.0), countingVoxels));
  });
}

std::shared_ptr<const Volume> volumeOf(const fs::path& path, const DicomSeries& series,
                                       const ReadOptions& options, const Progress& progress,
                                       std::vector<Message> warnings) {
  DicomGeometry geometry =
      naming(path, [&] { return geometryOf(series, options.spacingMm.has_value(), warnings); });
  const DicomHeader& first = *series.front().header;
  const glm::ivec3 sourceDims(first.columns, first.rows, static_cast<int>(series.size()));
  requireRoom(path, glm::max(sourceDims, geometry.grid.dims));
  if (options.part && !geometry.needsResampling)
    return partOfSeries(path, series, geometry, options, progress, std::move(warnings));
  if (options.part)
    warnings.emplace_back(notStraightInParts);
  const DicomKeeping keeping{path, options.memory.value_or(MemoryBudget()), geometry.needsResampling};
  DicomVoxels voxels = readVoxels(
      series, keeping, part(progress, headersShare, geometry.needsResampling ? 0.75 : 0.95), warnings);
  if (geometry.needsResampling)
    voxels =
        resampled(std::move(voxels), sourceDims, geometry, keeping, part(progress, 0.75, 0.95), warnings);
  if (voxels.bitsIgnored)
    warnings.emplace_back(bitsIgnoredWarning);
  applySpacing(options, geometry);
  requirePlausible(path, geometry.grid);
  return naming(path, [&] {
    return std::make_shared<const Volume>(geometry.grid, storedVoxels(std::move(voxels.stored)),
                                          voxels.rescale, voxels.padding, infoOf(series, geometry, warnings),
                                          effortOf(part(progress, 0.95, 1.0), countingVoxels), voxels.room);
  });
}

} // namespace

DicomFolder::DicomFolder(fs::path path, DicomHeaders headers)
    : m_path(std::move(path)), m_headers(std::move(headers)), m_series(seriesOf(m_headers.images)) {}

std::vector<SeriesSummary> DicomFolder::summaries() const {
  std::vector<SeriesSummary> summaries;
  for (const DicomSeries& series : m_series)
    if (series.front().header->pixels) {
      summaries.push_back(summaryOf(series, static_cast<int>(summaries.size()) + 1));
      const fs::path folder = series.front().header->path.parent_path().lexically_relative(m_path);
      summaries.back().folder = folder == "." ? std::string() : folder.generic_string();
    }
  return summaries;
}

std::vector<SeriesImages> DicomFolder::images() const {
  std::vector<SeriesImages> all;
  for (const DicomSeries& series : m_series) {
    std::vector<Message> said; // by the reader, where the series is read
    const DicomSeries shown = shownOf(series, said);
    const DicomHeader& first = *shown.front().header;
    SeriesImages images{
        static_cast<int>(all.size()) + 1, first.studyInstance, first.seriesInstance, {}, first.path};
    std::set<const DicomHeader*> listed; // a file may hold many slices
    for (const DicomSlice& slice : shown)
      if (listed.insert(slice.header).second)
        images.images.push_back({slice.header->sopClass, slice.header->sopInstance});
    for (const DicomSlice& slice : series)
      if (listed.insert(slice.header).second)
        images.leftOut.push_back(slice.header->sopInstance);
    all.push_back(std::move(images));
  }
  return all;
}

std::shared_ptr<const Volume> DicomFolder::read(const ReadOptions& options, const Progress& progress) const {
  requireImages(m_path, m_headers);
  std::vector<Message> warnings;
  noteFiles(m_path, m_headers, warnings);
  const DicomSeries series = shownOf(chosenSeries(m_path, m_series, options, warnings), warnings);
  requireSeries(series);
  return volumeOf(m_path, series, options, progress, std::move(warnings));
}

std::shared_ptr<const DicomFolder> openDicom(const fs::path& path, const Progress& progress) {
  auto headers = headersAt(path, part(progress, 0.0, headersShare));
  return headers ? std::make_shared<const DicomFolder>(path, std::move(*headers)) : nullptr;
}

} // namespace limn
