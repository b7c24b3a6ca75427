// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/TarEntries.h"

#include "io/formats/ReadError.h"

#include <archive.h>
#include <archive_entry.h>

#include <memory>

namespace limn {
namespace {

constexpr std::size_t blockBytes = 1 << 16;

using Archive = std::unique_ptr<archive, decltype(&archive_read_free)>;

[[noreturn]] void failDamaged(const std::filesystem::path& file) {
  failReading(file, "its archive is damaged or cut off", copyAgain);
}

Archive openArchive(const std::filesystem::path& file) {
  Archive opened(archive_read_new(), &archive_read_free);
  archive_read_support_filter_gzip(opened.get());
  archive_read_support_format_tar(opened.get());
  if (archive_read_open_filename(opened.get(), file.c_str(), blockBytes) != ARCHIVE_OK)
    failDamaged(file);
  return opened;
}

} // namespace

bool withTarEntry(const std::filesystem::path& file, const std::string& name,
                  const std::function<void(std::uint64_t size, const ByteReader& bytes)>& use) {
  const Archive opened = openArchive(file);
  archive_entry* entry = nullptr;
  int status = ARCHIVE_OK;
  while ((status = archive_read_next_header(opened.get(), &entry)) == ARCHIVE_OK) {
    const char* entryName = archive_entry_pathname(entry);
    if (!entryName || std::filesystem::path(entryName).filename() != name)
      continue;
    const ByteReader bytes = [&](unsigned char* to, std::size_t count) {
      const la_ssize_t got = archive_read_data(opened.get(), to, count);
      if (got < 0)
        failDamaged(file);
      return static_cast<std::size_t>(got);
    };
    use(static_cast<std::uint64_t>(archive_entry_size(entry)), bytes);
    return true;
  }
  if (status != ARCHIVE_EOF)
    failDamaged(file);
  return false;
}

} // namespace limn
