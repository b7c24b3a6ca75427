// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pictures/SmallVolumes.h"

#include <fstream>

namespace limn::test {
namespace {

constexpr int size = 32;

std::string text(const glm::dvec3& vector) {
  return "(" + std::to_string(vector.x) + "," + std::to_string(vector.y) + "," + std::to_string(vector.z) +
         ")";
}

// The box of the grid, divided into 32³ voxels.
void writePlace(std::ostream& file, const Grid& grid) {
  const glm::dvec3 spacing = glm::dvec3(grid.dims) * grid.spacingMm / double(size);
  file << "space: left-posterior-superior\nspace directions:";
  for (int axis = 0; axis < 3; ++axis)
    file << ' ' << text(grid.direction[axis] * spacing[axis]);
  file << "\nspace origin: " << text(grid.originMm + grid.direction * ((spacing - grid.spacingMm) / 2.0))
       << "\n";
}

void writeNames(std::ostream& file) {
  const char* const names[] = {"Skull", "Grey matter", "White matter", "Ventricles with a long name"};
  const char* const colors[] = {"0.95 0.9 0.75", "0.8 0.5 0.45", "0.9 0.8 0.75", "0.3 0.5 0.9"};
  for (int i = 0; i < 4; ++i) {
    const std::string segment = "Segment" + std::to_string(i);
    file << segment << "_ID:=part" << i << "\n"
         << segment << "_Name:=" << names[i] << "\n"
         << segment << "_Color:=" << colors[i] << "\n"
         << segment << "_LabelValue:=" << i + 1 << "\n";
  }
}

} // namespace

void writeBall(const std::filesystem::path& path, const Grid& grid, BallKind kind) {
  const bool isLabels = kind == BallKind::labels;
  std::ofstream file(path, std::ios::binary);
  file << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 32 32 32\nencoding: raw\n";
  if (isLabels) {
    writePlace(file, grid);
    writeNames(file);
  } else {
    file << "spacings: 2 2 2\n";
  }
  file << "\n";
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double radius = glm::length(glm::dvec3(x, y, z) + 0.5 - size / 2.0) / (size / 2.0);
        const double inside = std::max(0.0, 1.0 - radius); // 1 in the middle
        file.put(static_cast<char>(isLabels ? static_cast<int>(std::ceil(4.0 * inside))
                                            : static_cast<int>(255.0 * inside)));
      }
}

} // namespace limn::test
