// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/AtomicFile.h"

#include "scene/Error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <random>
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
  explicit TemporaryFile(fs::path target) : m_target(std::move(target)) {
    std::random_device random;
    for (int attempt = 0; attempt < 100; ++attempt) {
      fs::path path = m_target.parent_path() / (".limn-" + std::to_string(random()));
      path += m_target.extension();
      const Descriptor made(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
      if (made.number() >= 0) {
        m_path = path;
        return;
      }
      if (errno != EEXIST)
        break;
    }
    failWriting(m_target, errno);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!m_path.empty())
      fs::remove(m_path, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return m_path; }

  // Puts the bytes on the disk before the name points to them. A file that is replaced hands on its rights.
  void replaceTarget() {
    if (!flush(m_path, O_RDONLY))
      failWriting(m_target, errno);
    struct stat old {};
    if (::stat(m_target.c_str(), &old) == 0 && ::chmod(m_path.c_str(), old.st_mode & 07777) != 0)
      failWriting(m_target, errno);
    if (::rename(m_path.c_str(), m_target.c_str()) != 0)
      failWriting(m_target, errno);
    m_path.clear();
    // The file is whole now; where a folder cannot be flushed its new name reaches the disk a little later.
    const fs::path folder = m_target.parent_path();
    flush(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY);
  }

private:
  static bool flush(const fs::path& path, int flags) {
    const Descriptor opened(::open(path.c_str(), flags | O_CLOEXEC));
    return opened.number() >= 0 && ::fsync(opened.number()) == 0;
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
  // A link stays; what it points to is replaced.
  TemporaryFile temporary(fs::is_symlink(target) ? fs::weakly_canonical(target) : target);
  write(temporary.path());
  temporary.replaceTarget();
}

void writeFileAtomically(const fs::path& target, std::string_view bytes) {
  replaceAtomically(target, [&](const fs::path& temporary) { writeAll(temporary, target, bytes); });
}

} // namespace limn
