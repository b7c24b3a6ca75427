// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <filesystem>
#include <fstream>

namespace limn::test {

/// Writes an NRRD file of 16-bit voxels, so many of so many mm each way, along the patient's axes from the
/// origin on, of `value(voxel)` each; makes its folder.
template <class Value>
void writeShorts(const std::filesystem::path& path, const glm::ivec3& dims, const glm::dvec3& spacingMm,
                 const Value& value) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: " << dims.x << ' '
       << dims.y << ' ' << dims.z << "\nspace directions: (" << spacingMm.x << ",0,0) (0," << spacingMm.y
       << ",0) (0,0," << spacingMm.z << ")\nspace origin: (0,0,0)\nencoding: raw\nendian: little\n\n";
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const int v = value(glm::ivec3(x, y, z));
        file.put(static_cast<char>(v & 0xFF)).put(static_cast<char>(v >> 8 & 0xFF));
      }
}

/// Of `size`³ voxels of 1 mm, in slices `sliceMm` apart.
template <class Value>
void writeShorts(const std::filesystem::path& path, int size, const Value& value, double sliceMm = 1.0) {
  writeShorts(path, glm::ivec3(size), glm::dvec3(1.0, 1.0, sliceMm), value);
}

} // namespace limn::test
