// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/Contact.h"

#include <bit>

namespace limn {
namespace {

using Word = BitGrid::Word;

std::size_t facesAlongRow(const Word* a, const Word* b, int words) {
  constexpr int topBit = BitGrid::wordBits - 1;
  std::size_t faces = 0;
  for (int w = 0; w < words; ++w) {
    const Word below = b[w] << 1 | (w > 0 ? b[w - 1] >> topBit : 0);
    const Word above = b[w] >> 1 | (w + 1 < words ? b[w + 1] << topBit : 0);
    faces += std::popcount(a[w] & below) + std::popcount(a[w] & above);
  }
  return faces;
}

std::size_t facesBetweenRows(const Word* a, const Word* b, int words) {
  std::size_t faces = 0;
  for (int w = 0; w < words; ++w)
    faces += std::popcount(a[w] & b[w]);
  return faces;
}

} // namespace

std::size_t sharedFaces(const BitGrid& a, const BitGrid& b) {
  const glm::ivec3& dims = a.dims();
  const int words = a.rowWords();
  std::size_t faces = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y) {
      faces += facesAlongRow(a.row(y, z), b.row(y, z), words);
      for (const glm::ivec2& near : {glm::ivec2(y - 1, z), {y + 1, z}, {y, z - 1}, {y, z + 1}})
        if (near.x >= 0 && near.x < dims.y && near.y >= 0 && near.y < dims.z)
          faces += facesBetweenRows(a.row(y, z), b.row(near.x, near.y), words);
    }
  return faces;
}

} // namespace limn
