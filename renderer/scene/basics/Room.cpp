// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Room.h"

#include "scene/basics/Error.h"
#include "scene/basics/MappingGuard.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/vfs.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

namespace limn {
namespace {

namespace fs = std::filesystem;

bool liesInMemory(const fs::path& folder) {
  struct statfs system {};
  return ::statfs(folder.c_str(), &system) == 0 &&
         (system.f_type == TMPFS_MAGIC || system.f_type == RAMFS_MAGIC);
}

std::optional<std::uint64_t> freeBytes(const fs::path& folder) {
  struct statvfs system {};
  if (::statvfs(folder.c_str(), &system) != 0)
    return std::nullopt;
  return static_cast<std::uint64_t>(system.f_bavail) * system.f_frsize;
}

Message gigabytes(std::uint64_t bytes) {
  return Message::fixed(static_cast<double>(bytes) / 1e9, 1);
}

[[noreturn]] void failFull(const fs::path& folder, std::uint64_t needed) {
  throw Error(
      Error::Kind::other,
      Message::tr("Cannot keep the volume's data in %1: they need %2 GB and %3 GB are free there; make "
                  "room, or set TMPDIR to a folder on a larger disk.")
          .arg(folder.string())
          .arg(gigabytes(needed))
          .arg(gigabytes(freeBytes(folder).value_or(0))));
}

[[noreturn]] void failMapping(const fs::path& path, const Message& reason) {
  throw Error(Error::Kind::other,
              Message::tr("Cannot read %1: %2; copy the file again.").arg(path.string()).arg(reason));
}

std::optional<std::uint64_t> sizeOf(const Descriptor& file) {
  struct stat facts {};
  if (::fstat(file.number(), &facts) != 0)
    return std::nullopt;
  return static_cast<std::uint64_t>(facts.st_size);
}

[[noreturn]] void failKeeping(const fs::path& folder, int error) {
  throw Error(Error::Kind::other,
              Message::tr("Cannot keep the volume's data in %1: %2; set TMPDIR to a folder "
                          "on a disk that can be written.")
                  .arg(folder.string())
                  .arg(std::strerror(error)));
}

// Some file systems make no files without a name.
Descriptor openNameless(const fs::path& folder) {
  Descriptor file(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
  if (file.number() >= 0)
    return file;
  std::string name = (folder / ".limn-XXXXXX").string();
  file = Descriptor(::mkostemp(name.data(), O_CLOEXEC));
  if (file.number() < 0)
    failKeeping(folder, errno);
  ::unlink(name.c_str());
  return file;
}

// Its blocks are reserved: writing to them later never finds the disk full.
int reserve(const Descriptor& file, std::size_t bytes) {
  int error = 0;
  do
    error = ::posix_fallocate(file.number(), 0, static_cast<off_t>(bytes));
  while (error == EINTR);
  return error;
}

} // namespace

fs::path Room::chosenFolder() {
  const char* chosen = std::getenv("TMPDIR");
  for (const fs::path& folder : {fs::path(chosen ? chosen : ""), fs::path("/var/tmp")}) {
    std::error_code unknown;
    if (fs::is_directory(folder, unknown) && !liesInMemory(folder))
      return folder;
  }
  throw Error(Error::Kind::other,
              Message::tr("Cannot keep the volume's data on disk: /var/tmp is missing or lies in memory; set "
                          "TMPDIR to a folder on a disk."));
}

void Room::require(std::uint64_t bytes) const {
  const fs::path folder = this->folder();
  if (const auto free = freeBytes(folder); free && bytes > *free)
    failFull(folder, bytes);
}

void* Room::take(std::size_t bytes) {
  if (bytes < smallest)
    return ::operator new(bytes);
  require(bytes);
  const fs::path folder = this->folder();
  const Descriptor file = openNameless(folder);
  if (const int error = reserve(file, bytes); error == ENOSPC || error == EFBIG || error == EDQUOT)
    failFull(folder, bytes);
  else if (error != 0)
    failKeeping(folder, error);
  void* place = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.number(), 0);
  if (place == MAP_FAILED)
    failKeeping(folder, errno);
  MappingGuard::watch(place, bytes, m_isDamaged);
  m_taken += bytes;
  return place;
}

void Room::giveBack(void* place, std::size_t bytes) noexcept {
  if (bytes < smallest) {
    ::operator delete(place);
    return;
  }
  MappingGuard::forget(place);
  ::munmap(place, bytes);
  m_taken -= bytes;
}

std::shared_ptr<const std::byte> Room::mapped(const fs::path& path, std::uint64_t offset, std::size_t bytes) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  const auto size = file.number() < 0 ? std::nullopt : sizeOf(file);
  if (!size)
    failMapping(path, std::strerror(errno));
  if (*size < offset || *size - offset < bytes)
    failMapping(path, Message::tr("it is too short"));
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t before = offset % page; // mappings begin at whole pages
  const std::size_t length = before + bytes;
  void* begin =
      ::mmap(nullptr, length, PROT_READ, MAP_SHARED, file.number(), static_cast<off_t>(offset - before));
  if (begin == MAP_FAILED)
    failMapping(path, std::strerror(errno));
  MappingGuard::watch(begin, length, m_isDamaged);
  const std::lock_guard lock(m_mutex);
  m_files.push_back({std::move(file), offset + bytes});
  const std::shared_ptr<const void> owner(begin, [room = shared_from_this(), length](void* mapping) {
    MappingGuard::forget(mapping);
    ::munmap(mapping, length);
  });
  return {owner, static_cast<const std::byte*>(begin) + before};
}

bool Room::isWhole() const {
  const std::lock_guard lock(m_mutex);
  // Zeros behind the new end of a file's last page come without a signal.
  return !m_isDamaged && std::ranges::all_of(m_files, [](const MappedFile& mapped) {
    const auto size = sizeOf(mapped.file);
    return size && *size >= mapped.least;
  });
}

} // namespace limn
