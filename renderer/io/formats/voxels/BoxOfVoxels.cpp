// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/voxels/BoxOfVoxels.h"

#include "io/reading/Bounds.h"
#include "io/reading/ReadError.h"
#include "scene/basics/Descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t bytesTogether = 1 << 20;

// So many bytes from a place in a file on.
void readAt(const fs::path& path, const Descriptor& file, std::uint64_t from, unsigned char* to,
            std::size_t bytes) {
  while (bytes > 0) {
    const ssize_t got = ::pread(file.number(), to, bytes, static_cast<off_t>(from));
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      failReading(path, Message::tr("its voxels end early"), copyAgain);
    from += static_cast<std::uint64_t>(got);
    to += got;
    bytes -= static_cast<std::size_t>(got);
  }
}

// The voxels of a box alone; what lies together in the file is read together.
template <class Stored>
RoomVector<Kept<Stored>> readBoxAs(const RunReader& read, const VoxelLayout& layout, const glm::ivec3& dims,
                                   const VoxelBox& box, const Progress& progress,
                                   const std::shared_ptr<Room>& room) {
  const glm::ivec3 size = box.upper - box.lower;
  const auto components = static_cast<std::size_t>(layout.components);
  const std::size_t bytesPerRow = static_cast<std::size_t>(size.x) * components * sizeof(Stored);
  const int rowsTogether =
      size.x == dims.x ? static_cast<int>(std::max<std::size_t>(1, bytesTogether / bytesPerRow)) : 1;
  RoomVector<Kept<Stored>> voxels(voxelsIn(box), room);
  std::vector<Stored> samples;
  Kept<Stored>* to = voxels.data();
  for (int z = box.lower.z; z < box.upper.z; ++z) {
    reportOrStop(progress, static_cast<double>(z - box.lower.z) / size.z, Message::tr("Reading voxels"));
    for (int y = box.lower.y; y < box.upper.y; y += rowsTogether) {
      const std::size_t count = static_cast<std::size_t>(size.x) *
                                static_cast<std::size_t>(std::min(rowsTogether, box.upper.y - y));
      const std::uint64_t from = voxelOffset(dims, box.lower.x, y, z) * components * sizeof(Stored);
      samples.resize(count * components);
      read(from, reinterpret_cast<unsigned char*>(samples.data()), samples.size() * sizeof(Stored));
      toNativeOrder(samples.data(), samples.size(), layout);
      for (std::size_t i = 0; i < count; ++i)
        *to++ = keptValue(samples.data() + i * components, layout.components);
    }
  }
  reportOrStop(progress, 1.0, Message::tr("Reading voxels"));
  return voxels;
}

} // namespace

RunReader seeking(const ByteLocation& location) {
  auto file = std::make_shared<const Descriptor>(::open(location.file.c_str(), O_RDONLY | O_CLOEXEC));
  if (file->number() < 0)
    failReading(location.file, std::strerror(errno), Message::tr("check the name and the right to read it"));
  return [location, file](std::uint64_t from, unsigned char* to, std::uint64_t bytes) {
    readAt(location.file, *file, location.offset + location.skip + from, to, bytes);
  };
}

RunReader passing(const fs::path& path, const ByteReader& all, const VoxelLayout& layout) {
  const std::size_t perVoxel = bytesPerVoxel(layout.type) * static_cast<std::size_t>(layout.components);
  return [=, at = std::uint64_t{0}, dropped = std::vector<unsigned char>(1 << 16)](
             std::uint64_t from, unsigned char* to, std::uint64_t bytes) mutable {
    const auto take = [&](unsigned char* place, std::uint64_t wanted) {
      const std::size_t got = all(place, wanted);
      at += got;
      if (got < wanted)
        failShort(path, at / perVoxel, layout.count);
    };
    while (at < from)
      take(dropped.data(), std::min<std::uint64_t>(dropped.size(), from - at));
    take(to, bytes);
  };
}

void readBox(const fs::path& file, const RunReader& read, const VoxelLayout& layout, const VoxelBox& box,
             const MemoryBudget& budget, const Progress& progress, VolumeParts& parts) {
  parts.held = box;
  parts.room = roomFor(file, bytesKept(layout, box), budget, parts.info.warnings);
  withStoredType(layout.type, [&](auto value) {
    parts.stored = readBoxAs<decltype(value)>(read, layout, parts.grid.dims, box, progress, parts.room);
  });
}

std::size_t voxelsIn(const VoxelBox& box) {
  const glm::ivec3 size = box.upper - box.lower;
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
         static_cast<std::size_t>(size.z);
}

double bytesKept(const VoxelLayout& layout, const VoxelBox& box) {
  return static_cast<double>(voxelsIn(box)) * static_cast<double>(bytesPerVoxel(layout.type));
}

} // namespace limn
