// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Room.h"

#include "scene/basics/Error.h"

#include <fcntl.h>

#include <linux/magic.h>

#include <signal.h>

#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/vfs.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

namespace limn {
namespace {

// Watches mapped memory whose file may lose pages (it shrinks, its disk fails): from then on zeros are read
// there and `isDamaged` is true, where the system otherwise ends the process with SIGBUS. Elsewhere that
// signal does what it did before.
class MappingGuard {
public:
  /// `isDamaged` must live until `forget`. Safe on several threads. Throws Error (other) where too many
  /// mappings are watched.
  static void watch(void* begin, std::size_t bytes, std::atomic<bool>& isDamaged);
  /// Before the memory is unmapped.
  static void forget(void* begin) noexcept;
};

// A few volumes at a time, each with some dozen arrays.
constexpr std::size_t mostMappings = 4096;

// Read by a signal's handler: nothing here takes a lock or memory.
struct Watched {
  std::atomic<std::uintptr_t> begin{0}; // 0: free
  std::atomic<std::uintptr_t> end{0};
  std::atomic<std::atomic<bool>*> isDamaged{nullptr};
};
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

std::array<Watched, mostMappings> watchedMappings;
std::atomic<std::size_t> mostWatched{0}; // all behind are free
std::mutex changingMappings;
struct sigaction actionBefore {};
std::uintptr_t bytesOfPage = 0;

// Where a whole file vanishes, each page would be a signal of its own.
constexpr std::uintptr_t replacedAtOnce = std::uintptr_t{1} << 20;

bool replace(const Watched& mapping, void* place) {
  char* const first = static_cast<char*>(place) - reinterpret_cast<std::uintptr_t>(place) % bytesOfPage;
  const std::uintptr_t bytes =
      std::min(replacedAtOnce, mapping.end.load() - reinterpret_cast<std::uintptr_t>(first));
  return ::mmap(first, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE,
                -1, 0) != MAP_FAILED;
}

bool isReplaced(void* place) {
  const auto address = reinterpret_cast<std::uintptr_t>(place);
  for (std::size_t i = 0; i < mostWatched; ++i) {
    const Watched& mapping = watchedMappings[i];
    const std::uintptr_t begin = mapping.begin;
    if (begin == 0 || address < begin || address >= mapping.end)
      continue;
    mapping.isDamaged.load()->store(true);
    return replace(mapping, place);
  }
  return false;
}

void onBusError(int signal, siginfo_t* info, void* context) {
  const int error = errno;
  const bool done = isReplaced(info->si_addr);
  errno = error;
  if (done)
    return;
  if ((actionBefore.sa_flags & SA_SIGINFO) != 0)
    actionBefore.sa_sigaction(signal, info, context);
  else if (actionBefore.sa_handler != SIG_DFL && actionBefore.sa_handler != SIG_IGN)
    actionBefore.sa_handler(signal);
  else
    ::sigaction(signal, &actionBefore, nullptr); // it comes again, and is not ours then
}

void install() {
  bytesOfPage = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  struct sigaction action {};
  action.sa_sigaction = onBusError;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGBUS, &action, &actionBefore);
}

void MappingGuard::watch(void* begin, std::size_t bytes, std::atomic<bool>& isDamaged) {
  const std::lock_guard lock(changingMappings);
  if (bytesOfPage == 0)
    install();
  const auto free =
      std::ranges::find_if(watchedMappings, [](const Watched& mapping) { return mapping.begin == 0; });
  if (free == watchedMappings.end())
    throw Error(Error::Kind::other, Message::tr("Too many volumes are open; close some of them."));
  free->isDamaged = &isDamaged;
  free->end = reinterpret_cast<std::uintptr_t>(begin) + bytes;
  free->begin = reinterpret_cast<std::uintptr_t>(begin);
  mostWatched =
      std::max<std::size_t>(mostWatched, static_cast<std::size_t>(free - watchedMappings.begin()) + 1);
}

void MappingGuard::forget(void* begin) noexcept {
  const std::lock_guard lock(changingMappings);
  for (Watched& mapping : watchedMappings)
    if (mapping.begin == reinterpret_cast<std::uintptr_t>(begin))
      mapping.begin = 0;
}

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
          .arg(folder.string(), gigabytes(needed), gigabytes(freeBytes(folder).value_or(0))));
}

[[noreturn]] void failMapping(const fs::path& path, const Message& reason) {
  throw Error(Error::Kind::other,
              Message::tr("Cannot read %1: %2; copy the file again.").arg(path.string(), reason));
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
                  .arg(folder.string(), std::strerror(error)));
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
