// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/AtomicFile.h"

#include "scene/Error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

namespace limn {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWriting(const fs::path& target, int error) {
  throw Error(Error::Kind::other, "Cannot write " + target.string() + ": " + std::strerror(error) +
                                      "; choose another folder or make room, the old file is untouched.");
}

// A file descriptor that closes itself.
class Descriptor {
public:
  explicit Descriptor(int number) : m_number(number) {}
  ~Descriptor() {
    if (m_number >= 0)
      ::close(m_number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return m_number; }

private:
  int m_number;
};

// A new empty file beside the target that is removed unless it took the target's place.
class TemporaryFile {
public:
  explicit TemporaryFile(const fs::path& target) : m_target(target) {
    const std::string ending = target.extension().string();
    std::string name = (target.parent_path() / (".limn-XXXXXX" + ending)).string();
    const Descriptor made(::mkstemps(name.data(), static_cast<int>(ending.size())));
    if (made.number() < 0)
      failWriting(target, errno);
    m_path = name;
    useUsualRights(made.number());
  }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!m_path.empty())
      fs::remove(m_path, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return m_path; }

  // Puts the bytes on the disk before the name points to them, then the name.
  void replaceTarget() {
    flush(m_path, O_RDWR);
    if (::rename(m_path.c_str(), m_target.c_str()) != 0)
      failWriting(m_target, errno);
    m_path.clear();
    const fs::path folder = m_target.parent_path();
    flush(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY);
  }

private:
  // mkstemps makes a private file; the target keeps its rights, a new one gets what the umask leaves.
  void useUsualRights(int descriptor) {
    struct stat old {};
    mode_t rights = 0;
    if (::stat(m_target.c_str(), &old) == 0) {
      rights = old.st_mode & 07777;
    } else {
      const mode_t mask = ::umask(0);
      ::umask(mask);
      rights = 0666 & ~mask;
    }
    if (::fchmod(descriptor, rights) != 0)
      failWriting(m_target, errno);
  }

  void flush(const fs::path& path, int flags) {
    const Descriptor opened(::open(path.c_str(), flags | O_CLOEXEC));
    // Some file systems cannot flush a folder; that is no failure of the file.
    if (opened.number() < 0 || (::fsync(opened.number()) != 0 && errno != EINVAL))
      failWriting(m_target, errno);
  }

  fs::path m_target;
  fs::path m_path;
};

void writeAll(const fs::path& path, const fs::path& target, std::string_view bytes) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (file.number() < 0)
    failWriting(target, errno);
  while (!bytes.empty()) {
    const ssize_t done = ::write(file.number(), bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR)
      continue;
    if (done < 0)
      failWriting(target, errno);
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

} // namespace

void replaceAtomically(const fs::path& target, const std::function<void(const fs::path& temporary)>& write) {
  if (target.filename().empty() || fs::is_directory(target))
    failWriting(target, EISDIR);
  TemporaryFile temporary(target);
  write(temporary.path());
  temporary.replaceTarget();
}

void writeFileAtomically(const fs::path& target, std::string_view bytes) {
  replaceAtomically(target, [&](const fs::path& temporary) { writeAll(temporary, target, bytes); });
}

} // namespace limn
