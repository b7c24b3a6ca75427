// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/Bounds.h"

#include "io/reading/ReadError.h"

#include <unistd.h>

namespace limn {

void requireMemory(const std::filesystem::path& path, double bytes) {
  const double present =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (bytes <= present)
    return;
  failReading(path,
              Message::tr("its voxels need %1 GiB of memory and this computer has %2")
                  .arg(Message::fixed(bytes / (1 << 30), 1), Message::fixed(present / (1 << 30), 1)),
              Message::tr("save a smaller volume"));
}

std::shared_ptr<Room> roomFor(const std::filesystem::path& path, double bytes, const MemoryBudget& budget,
                              std::vector<Message>& warnings) {
  if (bytes <= budget.voxelBytes()) {
    requireMemory(path, bytes);
    return nullptr;
  }
  auto room = std::make_shared<Room>();
  naming(path, [&] { room->require(static_cast<std::uint64_t>(bytes)); });
  warnings.push_back(
      Message::tr("The voxels are kept on disk while the volume is open (%1 GB in %2), because "
                  "they need more memory than may be used.")
          .arg(Message::fixed(bytes / 1e9, 1), room->folder().string()));
  return room;
}

void requirePlausible(const std::filesystem::path& path, const Grid& grid) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(grid.spacingMm[axis] >= 1e-7) || !(grid.spacingMm[axis] <= 1e6))
      failReading(
          path,
          Message::tr("its voxel spacing of %1 mm is damaged").arg(Message::rounded(grid.spacingMm[axis], 6)),
          Message::tr("give the true one with --spacing X,Y,Z"));
  const double away = glm::length(grid.originMm);
  if (!(away <= 1e9))
    failReading(
        path, Message::tr("its header places it %1 mm away, which is damage").arg(Message::rounded(away, 6)),
        Message::tr("export it again"));
}

} // namespace limn
