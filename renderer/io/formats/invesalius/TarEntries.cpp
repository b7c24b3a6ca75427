// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/invesalius/TarEntries.h"

#include "io/reading/ReadError.h"

#include <archive.h>
#include <archive_entry.h>

#include <memory>

namespace limn {
namespace {

constexpr std::size_t blockBytes = 1 << 16;
constexpr std::uint64_t mostPassed = std::uint64_t{2} << 30; // masks and surfaces of a project
// Masks compress a hundredfold and the matrix beside them hardly, so what is passed over shrinks less as a
// whole.
constexpr std::uint64_t leastSuspicious = std::uint64_t{256} << 20;
constexpr std::uint64_t mostPackedRatio = 100;
constexpr int mostEntries = 10000;

using Archive = std::unique_ptr<archive, decltype(&archive_read_free)>;

[[noreturn]] void failDamagedArchive(const std::filesystem::path& file) {
  failReading(file, Message::tr("its archive is damaged or cut off"), copyAgain);
}

Archive openArchive(const std::filesystem::path& file) {
  Archive opened(archive_read_new(), &archive_read_free);
  archive_read_support_filter_gzip(opened.get());
  archive_read_support_format_tar(opened.get());
  if (archive_read_open_filename(opened.get(), file.c_str(), blockBytes) != ARCHIVE_OK)
    failDamagedArchive(file);
  return opened;
}

// Counts what is passed over on the way to an entry: an archive that never comes to it is a bomb.
void passOver(const std::filesystem::path& file, archive* opened, std::uint64_t& passed) {
  const void* block = nullptr;
  std::size_t size = 0;
  la_int64_t offset = 0;
  int status = ARCHIVE_OK;
  while ((status = archive_read_data_block(opened, &block, &size, &offset)) == ARCHIVE_OK) {
    passed += size;
    if (passed > mostPassed ||
        (passed > leastSuspicious && passed / mostPackedRatio > std::filesystem::file_size(file)))
      failReading(file, Message::tr("its archive holds gigabytes before the project"),
                  Message::tr("open it in InVesalius and save it again"));
  }
  if (status != ARCHIVE_EOF)
    failDamagedArchive(file);
}

} // namespace

bool withTarEntry(const std::filesystem::path& file, const std::string& name,
                  const std::function<void(std::uint64_t size, const ByteReader& bytes)>& use) {
  const Archive opened = openArchive(file);
  archive_entry* entry = nullptr;
  std::uint64_t passed = 0;
  int entries = 0;
  int status = ARCHIVE_OK;
  while ((status = archive_read_next_header(opened.get(), &entry)) == ARCHIVE_OK) {
    const char* entryName = archive_entry_pathname(entry);
    if (++entries > mostEntries)
      failDamagedArchive(file);
    if (!entryName || std::filesystem::path(entryName).filename() != name) {
      passOver(file, opened.get(), passed);
      continue;
    }
    // A sparse entry says how many zeros it has without holding them.
    if (archive_entry_sparse_count(entry) > 0)
      failDamagedArchive(file);
    const ByteReader bytes = [&](unsigned char* to, std::size_t count) {
      const la_ssize_t got = archive_read_data(opened.get(), to, count);
      if (got < 0)
        failDamagedArchive(file);
      return static_cast<std::size_t>(got);
    };
    use(static_cast<std::uint64_t>(archive_entry_size(entry)), bytes);
    return true;
  }
  if (status != ARCHIVE_EOF)
    failDamagedArchive(file);
  return false;
}

} // namespace limn
