// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/FileLock.h"

#include "scene/basics/Error.h"
#include "scene/basics/SystemReason.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>

namespace limn {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failLocking(const fs::path& file, int error) {
  throw Error(Error::Kind::other,
              Message::tr("Cannot write %1: %2; check that the folder exists, may be written and has room.")
                  .arg(file.string(), systemReason(error)));
}

Descriptor opened(const fs::path& file) {
  Descriptor made(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  if (made.number() < 0)
    failLocking(file, errno);
  return made;
}

// 0, or the reason for which it is not locked.
int locked(const Descriptor& file, int how) {
  while (::flock(file.number(), how) != 0)
    if (errno != EINTR)
      return errno;
  return 0;
}

} // namespace

FileLock FileLock::waitFor(const fs::path& file) {
  Descriptor made = opened(file);
  if (const int error = locked(made, LOCK_EX))
    failLocking(file, error);
  return FileLock(std::move(made));
}

std::optional<FileLock> FileLock::tryFor(const fs::path& file) {
  Descriptor made = opened(file);
  const int error = locked(made, LOCK_EX | LOCK_NB);
  if (error == EWOULDBLOCK)
    return std::nullopt;
  if (error)
    failLocking(file, error);
  return FileLock(std::move(made));
}

} // namespace limn
