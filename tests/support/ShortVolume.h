// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <filesystem>
#include <fstream>

namespace limn::test {

/// Writes an NRRD file of `size`³ 16-bit voxels of 1 mm, in slices `sliceMm` apart, along the patient's axes
/// from the origin on, of `value(voxel)` each; makes its folder.
template <class Value>
void writeShorts(const std::filesystem::path& path, int size, const Value& value, double sliceMm = 1.0) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: " << size << ' '
       << size << ' ' << size << "\nspace directions: (1,0,0) (0,1,0) (0,0," << sliceMm
       << ")\nspace origin: (0,0,0)\nencoding: raw\nendian: little\n\n";
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const int v = value(glm::ivec3(x, y, z));
        file.put(static_cast<char>(v & 0xFF)).put(static_cast<char>(v >> 8 & 0xFF));
      }
}

} // namespace limn::test
