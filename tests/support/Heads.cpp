// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/Heads.h"

#include "support/TestData.h"

#include <zlib.h>

#include <cstring>
#include <stdexcept>

namespace limn::test {
namespace {

std::vector<char> inflated(const std::string& path) {
  const gzFile file = gzopen(path.c_str(), "rb");
  if (!file)
    throw std::runtime_error("cannot open " + path);
  std::vector<char> bytes;
  char block[1 << 16];
  for (int read = gzread(file, block, sizeof(block)); read > 0; read = gzread(file, block, sizeof(block)))
    bytes.insert(bytes.end(), block, block + read);
  gzclose(file);
  return bytes;
}

template <class T>
T field(const std::vector<char>& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

} // namespace

std::shared_ptr<const Volume> ctHead() {
  const std::vector<char> bytes = inflated((sharedFolder() / ctHeadFile).string());
  // NIfTI-1: dim at 40, pixdim at 76, vox_offset at 108, the sform's rows at 280.
  Grid grid;
  for (int axis = 0; axis < 3; ++axis) {
    grid.dims[axis] = field<std::int16_t>(bytes, 42 + 2 * static_cast<std::size_t>(axis));
    grid.spacingMm[axis] = field<float>(bytes, 80 + 4 * static_cast<std::size_t>(axis));
  }
  // RAS to LPS negates the first two rows.
  for (std::size_t row = 0; row < 3; ++row) {
    const double sign = row < 2 ? -1.0 : 1.0;
    for (std::size_t column = 0; column < 3; ++column)
      grid.direction[static_cast<int>(column)][static_cast<int>(row)] = std::round(
          sign * field<float>(bytes, 280 + 16 * row + 4 * column) / grid.spacingMm[static_cast<int>(column)]);
    grid.originMm[static_cast<int>(row)] = sign * field<float>(bytes, 280 + 16 * row + 12);
  }
  const auto start = static_cast<std::size_t>(field<float>(bytes, 108));
  std::vector<std::int16_t> voxels((bytes.size() - start) / 2);
  std::memcpy(voxels.data(), bytes.data() + start, voxels.size() * 2);
  return std::make_shared<const Volume>(grid, std::move(voxels), Rescale{}, std::nullopt, VolumeInfo{});
}

TransferFunction boneOnly() {
  return {1.0, {{150, {0.9, 0.8, 0.6}, 0.0}, {400, {1.0, 0.95, 0.85}, 0.8}, {1500, {1.0, 1.0, 1.0}, 0.95}}};
}

} // namespace limn::test
