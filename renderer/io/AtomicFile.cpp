// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/AtomicFile.h"

#include "scene/basics/Descriptor.h"
#include "scene/basics/Error.h"
#include "scene/basics/SystemReason.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <random>
#include <string>
#include <system_error>

namespace limn {
namespace {

namespace fs = std::filesystem;

struct Target {
  fs::path path;
  FilePlace place = FilePlace::chosen;
};

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// Of what cannot be made in a folder that is there, as in /proc, the system says that there is none.
Message reasonAgainst(const fs::path& made, int error) {
  std::error_code unknown;
  const fs::path folder = folderOf(made);
  return error == ENOENT && fs::is_directory(folder, unknown)
             ? Message::tr("the folder %1 takes no files").arg(folder.string())
             : systemReason(error);
}

[[noreturn]] void failWriting(const Target& target, int error) {
  std::error_code unknown;
  if (error == ENOENT && target.place == FilePlace::chosen && !fs::exists(folderOf(target.path), unknown))
    throw Error(Error::Kind::other,
                Message::tr("Cannot write %1: there is no folder %2; make it, or choose another folder.")
                    .arg(target.path.string(), target.path.parent_path().string()));
  const bool isFull = error == ENOSPC || error == EDQUOT;
  const Message advice = target.place != FilePlace::chosen
                             ? Message::tr("make room there or allow Limn to write there")
                         : isFull          ? Message::tr("choose another folder or make room")
                         : error == EISDIR ? Message::tr("choose another name")
                                           : Message::tr("choose another folder");
  const bool isThere = fs::is_regular_file(target.path, unknown);
  throw Error(Error::Kind::other,
              (isThere ? Message::tr("Cannot write %1: %2; %3, the old file is untouched.")
                       : Message::tr("Cannot write %1: %2; %3."))
                  .arg(target.path.string(), reasonAgainst(target.path, error), advice));
}

const std::string prefix = ".limn-";

// Whether a file has the name that TemporaryFile gives: the prefix, digits, an ending.
bool isTemporaryName(const std::string& name) {
  if (!name.starts_with(prefix))
    return false;
  const auto rest = std::find_if(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(),
                                 [](unsigned char c) { return !std::isdigit(c); });
  return rest != name.begin() + static_cast<std::ptrdiff_t>(prefix.size()) &&
         (rest == name.end() || *rest == '.');
}

// Whoever writes a temporary file holds a lock on it; one without belongs to a process that was killed.
void removeAbandoned(const fs::path& folder) {
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code unknown;
    if (!isTemporaryName(entry->path().filename().string()) || !entry->is_regular_file(unknown))
      continue;
    const Descriptor file(::open(entry->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
    if (file.number() >= 0 && ::flock(file.number(), LOCK_EX | LOCK_NB) == 0)
      ::unlink(entry->path().c_str());
  }
}

// A new empty file beside the target that is removed unless it took the target's place; locked meanwhile.
class TemporaryFile {
public:
  explicit TemporaryFile(Target target) : m_target(std::move(target)) {
    const mode_t rights = m_target.place == FilePlace::fixedPrivate ? 0600 : 0666;
    std::random_device random;
    for (int attempt = 0; attempt < 100; ++attempt) {
      fs::path path = m_target.path.parent_path() / (prefix + std::to_string(random()));
      path += m_target.path.extension();
      m_made = Descriptor(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, rights));
      if (m_made.number() < 0 && errno != EEXIST)
        break;
      if (m_made.number() < 0 || !isMine())
        continue;
      m_path = path;
      return;
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

  // Puts the bytes on the disk before the name points to them. A file that is replaced hands on
  // its rights.
  void replaceTarget() {
    if (!flush(m_path, O_RDONLY))
      failWriting(m_target, errno);
    struct stat old {};
    if (m_target.place != FilePlace::fixedPrivate && ::stat(m_target.path.c_str(), &old) == 0 &&
        ::chmod(m_path.c_str(), old.st_mode & 07777) != 0)
      failWriting(m_target, errno);
    if (::rename(m_path.c_str(), m_target.path.c_str()) != 0)
      failWriting(m_target, errno);
    m_path.clear();
    // The file is whole now; where a folder cannot be flushed its new name reaches the disk a little later.
    const fs::path folder = m_target.path.parent_path();
    flush(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY);
  }

private:
  // Locks the new file. Somebody who cleans up may have removed it before that.
  bool isMine() const {
    struct stat made {};
    ::flock(m_made.number(), LOCK_EX);
    return ::fstat(m_made.number(), &made) == 0 && made.st_nlink > 0;
  }

  static bool flush(const fs::path& path, int flags) {
    const Descriptor opened(::open(path.c_str(), flags | O_CLOEXEC));
    return opened.number() >= 0 && ::fsync(opened.number()) == 0;
  }

  Target m_target;
  fs::path m_path;
  Descriptor m_made;
};

void writeAll(const fs::path& path, const Target& target, std::string_view bytes) {
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

// The file that is replaced: a link stays, what it points to is not.
fs::path replacedBy(const fs::path& target, FilePlace place) {
  std::error_code unknown;
  if (target.filename().empty() || fs::is_directory(target, unknown))
    failWriting({target, place}, EISDIR);
  return fs::is_symlink(target, unknown) ? fs::weakly_canonical(target) : target;
}

} // namespace

void requireWritable(const fs::path& target) {
  // Tried: rights do not tell of every file system.
  const TemporaryFile removedAtOnce({replacedBy(target, FilePlace::chosen), FilePlace::chosen});
}

void replaceAtomically(const fs::path& target, const std::function<void(const fs::path& temporary)>& write,
                       FilePlace place) {
  const fs::path file = replacedBy(target, place);
  removeAbandoned(folderOf(file));
  TemporaryFile temporary({file, place});
  write(temporary.path());
  temporary.replaceTarget();
}

bool isTemporary(const fs::path& file) {
  return isTemporaryName(file.filename().string());
}

void writeFileAtomically(const fs::path& target, std::string_view bytes, FilePlace place) {
  replaceAtomically(
      target,
      [&](const fs::path& temporary) {
        writeAll(temporary, {target, place}, bytes);
      },
      place);
}

Message makeFolders(const fs::path& folder) {
  std::error_code unknown, failed;
  if (folder.empty()) // the current one, as of a file without a folder
    return {};
  fs::path first = fs::absolute(folder); // the outermost that is missing
  while (!fs::exists(folderOf(first), unknown) && folderOf(first).has_relative_path())
    first = folderOf(first);
  fs::create_directories(folder, failed);
  return failed ? reasonAgainst(first, failed.value()) : Message();
}

ScratchFolder::ScratchFolder(const std::filesystem::path& parent) {
  const char* given = std::getenv("TMPDIR");
  const std::filesystem::path system = given && *given ? given : "/tmp";
  std::string pattern = (parent.empty() ? system / "limn-XXXXXX" : parent / ".limn-XXXXXX").string();
  if (!mkdtemp(pattern.data()))
    throw Error(Error::Kind::other, reasonAgainst(pattern, errno));
  m_path = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code left;
  std::filesystem::remove_all(m_path, left);
}

} // namespace limn
