// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/LabelReader.h"

#include "io/VolumeReader.h"
#include "io/dicom/DicomSegmentation.h"
#include "io/formats/nifti/NiftiFile.h"
#include "io/formats/nrrd/NrrdFile.h"
#include "io/formats/voxels/Bytes.h"
#include "io/labels/CaretLabels.h"
#include "io/labels/LabelNames.h"
#include "io/labels/MaskFolder.h"
#include "io/reading/ReadError.h"
#include "regions/LabelsOnGrid.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <vector>

namespace limn {
namespace {

constexpr std::size_t longestName = 200;

std::optional<int> wholeNumber(const std::string& text) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failed == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<glm::dvec3> colorIn(const std::string& text) {
  std::istringstream numbers(text);
  numbers.imbue(std::locale::classic());
  glm::dvec3 color;
  if (!(numbers >> color.r >> color.g >> color.b))
    return std::nullopt;
  return glm::clamp(color, 0.0, 1.0);
}

std::string keyIn(const NrrdHeader& header, const std::string& key) {
  const auto found = header.keys.find(key);
  return found == header.keys.end() ? std::string() : found->second;
}

// The segments that 3D Slicer writes as keys into a NRRD header (Segment0_Name, Segment0_LabelValue,
// Segment0_Color). A segment without a sound label value is left out.
std::vector<Label> slicerSegments(const NrrdHeader& header) {
  std::vector<Label> labels;
  for (int n = 0; header.keys.contains("Segment" + std::to_string(n) + "_ID") ||
                  header.keys.contains("Segment" + std::to_string(n) + "_Name");
       ++n) {
    const std::string segment = "Segment" + std::to_string(n);
    const std::optional<int> value = wholeNumber(keyIn(header, segment + "_LabelValue"));
    const std::optional<glm::dvec3> color = colorIn(keyIn(header, segment + "_Color"));
    if (value)
      labels.push_back({*value, plainText(keyIn(header, segment + "_Name"), longestName),
                        color.value_or(glm::dvec3(1.0))});
  }
  return labels;
}

namespace fs = std::filesystem;

} // namespace

bool mayBeMask(const fs::path& file) {
  return !volumeStem(file).empty() || isDicomSegmentation(file);
}

LabelVolume readLabelVolume(const fs::path& path, const Progress& progress, const PatientLabel& patient) {
  if (isDicomSegmentation(path)) {
    DicomSegments segments = readDicomSegmentation(path, progress);
    return {std::move(segments.numbers), std::move(segments.labels)};
  }
  LabelVolume labels{readVolume(path, {}, progress), {}};
  if (!fs::is_regular_file(path))
    return labels;
  if (isNrrd(firstBytes(path, 16)))
    labels.described = slicerSegments(readNrrdHeader(path));
  for (const std::string& extension : niftiExtensions(path))
    for (Label& label : caretLabels(extension))
      labels.described.push_back(std::move(label));
  if (std::ranges::all_of(labels.described, [](const Label& label) { return label.name.empty(); }))
    labels.structure = structureName(path, patient);
  return labels;
}

namespace {

// How much of the volume the labels' box covers at all: centres of voxels, of which a few rows tell enough.
bool overlaps(const Grid& a, const Grid& b) {
  constexpr int probes = 16;
  for (int z = 0; z <= probes; ++z)
    for (int y = 0; y <= probes; ++y)
      for (int x = 0; x <= probes; ++x) {
        const glm::dvec3 share = glm::dvec3(x, y, z) / static_cast<double>(probes);
        const glm::dvec3 index = worldToIndex(b, indexToWorld(a, share * glm::dvec3(a.dims) - 0.5));
        if (glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) &&
            glm::all(glm::lessThanEqual(index, glm::dvec3(b.dims) - 0.5)))
          return true;
      }
  return false;
}

} // namespace

void requireNear(const fs::path& path, const Grid& labels, const Grid& volume) {
  if (!overlaps(labels, volume) && !overlaps(volume, labels))
    failReading(path, Message::tr("it lies elsewhere than the volume"),
                Message::tr("open the label map that belongs to this volume"));
}

std::string sourceOf(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).string();
}

Segmentation readSegmentation(const fs::path& path, const Grid& grid, const Progress& progress,
                              const PatientLabel& patient) {
  if (isMaskFolder(path))
    return readMaskFolder(path, grid, progress, patient);
  const LabelVolume labels = readLabelVolume(path, part(progress, 0.0, 0.6), patient);
  requireNear(path, labels.volume->grid(), grid);
  return naming(path, [&] {
    const auto map =
        labelsOnGrid(*labels.volume, labels.described, grid,
                     effortOf(part(progress, 0.6, 1.0), Message::tr("Placing labels")), labels.structure);
    Region region{Region::Kind::labels, sourceOf(path), map, std::vector<double>(map->labels().size(), 1.0)};
    region.isOfFile = mayBeMask(path);
    return Segmentation{region, {}};
  });
}

Segmentation readSegmentations(const std::vector<fs::path>& paths, const Grid& grid, const Progress& progress,
                               const PatientLabel& patient) {
  return paths.size() == 1 ? readSegmentation(paths.front(), grid, progress, patient)
                           : readMasks(paths, grid, progress, patient);
}

Region readLabels(const fs::path& path, const Grid& grid, const Progress& progress) {
  return readSegmentation(path, grid, progress).region;
}

} // namespace limn
