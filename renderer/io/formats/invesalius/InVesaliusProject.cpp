// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/invesalius/InVesaliusProject.h"

#include "io/formats/voxels/AxisGrid.h"
#include "io/formats/voxels/Bytes.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <archive.h>

#include <archive_entry.h>

#include <pugixml.hpp>

#include <map>
#include <memory>
#include <string>

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

// Goes through the files of a tar archive (plain or gzipped) to the first of this name, whatever its
// folder, and calls `use` with its size and its bytes. False where there is none. Throws Error where the
// archive is damaged.
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

namespace fs = std::filesystem;

constexpr std::uint64_t longestPlist = 1 << 20;
constexpr int axialSlices = 1;

// The value that follows a key among the children of a <dict>.
pugi::xml_node valueOf(const pugi::xml_node& dict, const char* key) {
  for (const pugi::xml_node& child : dict.children("key"))
    if (std::string(child.text().as_string()) == key)
      return child.next_sibling();
  return {};
}

std::vector<double> listOf(const fs::path& file, const pugi::xml_node& array) {
  std::vector<double> values;
  for (const pugi::xml_node& item : array.children())
    values.push_back(number(file, item.text().as_string()));
  if (values.size() != 3)
    failReading(file, Message::tr("its project list names no volume of three dimensions"),
                Message::tr("open it in InVesalius and save it again"));
  return values;
}

// The dictionary of main.plist.
pugi::xml_document mainList(const fs::path& file) {
  pugi::xml_document document;
  const bool found = withTarEntry(file, "main.plist", [&](std::uint64_t size, const ByteReader& bytes) {
    if (size > longestPlist)
      failReading(file, Message::tr("its project list is too long"), copyAgain);
    std::string text(size, '\0');
    text.resize(bytes(reinterpret_cast<unsigned char*>(text.data()), text.size()));
    if (!document.load_buffer(text.data(), text.size()))
      failReading(file, Message::tr("its project list is damaged"), copyAgain);
  });
  if (!found)
    failReading(file, Message::tr("it is an archive but no InVesalius 3 project (it has no main.plist)"),
                Message::tr("unpack it and open the volume inside"));
  return document;
}

VoxelType typeOf(const fs::path& file, const std::string& name) {
  static const std::map<std::string, VoxelType> types = {
      {"uint8", VoxelType::uint8},     {"int8", VoxelType::int8},       {"uint16", VoxelType::uint16},
      {"int16", VoxelType::int16},     {"int32", VoxelType::int32},     {"uint32", VoxelType::uint32},
      {"float32", VoxelType::float32}, {"float64", VoxelType::float64},
  };
  const auto found = types.find(name);
  if (found == types.end())
    failReading(file, Message::tr("its voxels are of the type \"%1\", which is not supported").arg(name),
                Message::tr("open it in InVesalius and save it again"));
  return found->second;
}

bool orientationIsKnown(const pugi::xml_node& project) {
  const bool isAxial = valueOf(project, "orientation").text().as_int() == axialSlices;
  // Projects made from a NIfTI file carry an affine map and keep another order of rows.
  const pugi::xml_node affine = valueOf(project, "affine");
  const bool hasAffine = affine && std::string(affine.name()) == "array" && affine.first_child();
  return isAxial && !hasAffine;
}

void describe(const pugi::xml_node& project, VolumeInfo& info) {
  info.format = "InVesalius";
  const std::string modality = valueOf(project, "modality").text().as_string();
  info.modality = modality == "MRI" ? "MR" : modality;
  info.unit = modality == "CT" ? "HU" : "";
  info.patient.name = valueOf(project, "name").text().as_string();
  info.orientationKnown = orientationIsKnown(project);
}

// Axial slices in InVesalius: columns to the patient's left, rows to the front, slices to the head.
Grid gridOf(const fs::path& file, const glm::ivec3& dims, const std::vector<double>& spacing) {
  const glm::dmat3 steps({spacing[0], 0.0, 0.0}, {0.0, -spacing[1], 0.0}, {0.0, 0.0, spacing[2]});
  return gridFromAxes(file, dims, steps, steps * (-0.5 * glm::dvec3(dims - 1)));
}

} // namespace

bool isTar(std::string_view bytes) {
  return bytes.size() >= 262 && bytes.substr(257, 5) == "ustar";
}

VolumeParts readInVesalius(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
  const pugi::xml_document document = mainList(path);
  const pugi::xml_node project = document.child("plist").child("dict");
  const pugi::xml_node matrix = valueOf(project, "matrix");
  const std::vector<double> shape = listOf(path, valueOf(matrix, "shape"));
  const glm::ivec3 dims(dimension(path, shape[2]), dimension(path, shape[1]), dimension(path, shape[0]));
  const std::string name = valueOf(matrix, "filename").text().as_string();

  VolumeParts parts;
  describe(project, parts.info);
  parts.grid = gridOf(path, dims, listOf(path, valueOf(project, "spacing")));
  VoxelLayout layout;
  layout.type = typeOf(path, valueOf(matrix, "dtype").text().as_string());
  layout.count = voxelCount(path, dims);
  const bool found = withTarEntry(path, name, [&](std::uint64_t size, const ByteReader& bytes) {
    if (size != bytesOf(layout))
      failReading(
          path,
          Message::tr("its matrix has %1 bytes where the project asks for %2").arg(size, bytesOf(layout)),
          copyAgain);
    readVoxels(path, bytes, layout, keeping, progress, 0, parts);
  });
  if (!found)
    failReading(path, Message::tr("its matrix \"%1\" is missing").arg(name), copyAgain);
  return parts;
}

} // namespace limn
