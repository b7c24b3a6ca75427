// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/LabelReader.h"

#include "io/VolumeReader.h"
#include "io/dicom/DicomSegmentation.h"
#include "io/formats/nrrd/NrrdHeader.h"
#include "io/formats/voxels/Bytes.h"
#include "io/labels/SlicerSegments.h"
#include "io/reading/ReadError.h"
#include "regions/LabelsOnGrid.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

// Labels as a volume on a grid of their own, and what the file says of them.
struct LabelVolume {
  std::shared_ptr<const Volume> volume;
  std::vector<Label> described;
};

LabelVolume readLabelVolume(const fs::path& path, const Progress& progress) {
  if (isDicomSegmentation(path)) {
    DicomSegments segments = readDicomSegmentation(path, progress);
    return {std::move(segments.numbers), std::move(segments.labels)};
  }
  LabelVolume labels{readVolume(path, {}, progress), {}};
  if (fs::is_regular_file(path) && isNrrd(firstBytes(path, 16)))
    labels.described = slicerSegments(readNrrdHeader(path));
  return labels;
}

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

Region readLabels(const fs::path& path, const Grid& grid, const Progress& progress) {
  const LabelVolume labels = readLabelVolume(path, part(progress, 0.0, 0.6));
  const Grid& own = labels.volume->grid();
  if (!overlaps(own, grid) && !overlaps(grid, own))
    failReading(path, Message::tr("it lies elsewhere than the volume"),
                Message::tr("open the label map that belongs to this volume"));
  return naming(path, [&] {
    const auto map = labelsOnGrid(*labels.volume, labels.described, grid,
                                  effortOf(part(progress, 0.6, 1.0), Message::tr("Placing labels")));
    return Region{Region::Kind::labels, fs::absolute(path).lexically_normal().string(), map,
                  std::vector<double>(map->labels().size(), 1.0)};
  });
}

} // namespace limn
