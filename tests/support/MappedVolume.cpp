// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/MappedVolume.h"

#include "scene/basics/Descriptor.h"
#include "scene/basics/Room.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <system_error>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

// A file's bytes where they are.
class Mapping {
public:
  Mapping(const Descriptor& file, std::size_t bytes, int protection) : m_bytes(bytes) {
    m_place = ::mmap(nullptr, bytes, protection, MAP_SHARED, file.number(), 0);
    if (m_place == MAP_FAILED)
      throw std::system_error(errno, std::generic_category(), "mmap");
  }
  ~Mapping() { ::munmap(m_place, m_bytes); }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  template <class T>
  T* as() const {
    return static_cast<T*>(m_place);
  }

private:
  void* m_place;
  std::size_t m_bytes;
};

struct Bytes {
  const unsigned char* begin;
  std::size_t size;
};

Bytes bytesOf(const Volume& volume) {
  return visitVoxels(volume, []<class T>(const StoredVoxels<T>& stored) {
    return Bytes{reinterpret_cast<const unsigned char*>(stored.data()), stored.size() * sizeof(T)};
  });
}

} // namespace

std::shared_ptr<const Volume> mapped(const Volume& volume, const fs::path& path) {
  const Bytes bytes = bytesOf(volume);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.begin), static_cast<std::streamsize>(bytes.size));
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  const auto mapping = std::make_shared<const Mapping>(file, bytes.size, PROT_READ);
  VoxelArray voxels = visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
    return VoxelArray(StoredVoxels<T>(std::span<const T>(mapping->as<const T>(), stored.size()), mapping));
  });
  return std::make_shared<const Volume>(volume.grid(), std::move(voxels), volume.rescale(), std::nullopt,
                                        volume.info(), Effort{}, std::make_shared<Room>());
}

std::shared_ptr<const Volume> sparseVolume(const glm::ivec3& dims,
                                           const std::function<void(std::int16_t*)>& write) {
  std::string name = (Room::chosenFolder() / "limn-sparse-XXXXXX").string();
  const Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
  ::unlink(name.c_str());
  const std::size_t voxels = static_cast<std::size_t>(dims.x) * dims.y * dims.z;
  const std::size_t bytes = voxels * sizeof(std::int16_t);
  if (::ftruncate(file.number(), static_cast<off_t>(bytes)) != 0)
    throw std::system_error(errno, std::generic_category(), "ftruncate");
  write(Mapping(file, bytes, PROT_READ | PROT_WRITE).as<std::int16_t>());
  const auto mapping = std::make_shared<const Mapping>(file, bytes, PROT_READ);
  Grid grid;
  grid.dims = dims;
  return std::make_shared<const Volume>(
      grid, StoredVoxels<std::int16_t>(std::span(mapping->as<const std::int16_t>(), voxels), mapping),
      Rescale{}, std::nullopt, VolumeInfo{}, Effort{}, std::make_shared<Room>());
}

void forgetPages(const Volume& volume) {
  const Bytes bytes = bytesOf(volume);
  if (::madvise(const_cast<unsigned char*>(bytes.begin), bytes.size, MADV_DONTNEED) != 0)
    throw std::system_error(errno, std::generic_category(), "madvise");
}

std::uint64_t touchedBytes(const Volume& volume) {
  const Bytes bytes = bytesOf(volume);
  std::ifstream maps("/proc/self/smaps");
  char begin[32];
  std::snprintf(begin, sizeof begin, "%lx-", reinterpret_cast<unsigned long>(bytes.begin));
  bool isIt = false;
  for (std::string line; std::getline(maps, line);) {
    isIt = isIt || line.starts_with(begin);
    if (isIt && line.starts_with("Rss:"))
      return std::stoull(line.substr(4)) * 1024;
  }
  throw std::runtime_error("the volume's file is not mapped by itself");
}

std::uint64_t ownMemory() {
  std::ifstream lines("/proc/self/status");
  for (std::string word; lines >> word;)
    if (std::uint64_t kibibytes = 0; word == "RssAnon:" && lines >> kibibytes)
      return kibibytes * 1024;
  throw std::runtime_error("the system tells no RssAnon");
}

} // namespace limn::test
