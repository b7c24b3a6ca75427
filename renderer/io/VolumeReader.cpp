// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/VolumeReader.h"

#include "io/dicom/DicomFolder.h"
#include "io/formats/invesalius/InVesaliusProject.h"
#include "io/formats/metaimage/MetaImageFile.h"
#include "io/formats/nifti/NiftiFile.h"
#include "io/formats/nrrd/NrrdFile.h"
#include "io/formats/pictures/PictureStack.h"
#include "io/formats/voxels/Bytes.h"
#include "io/formats/vtk/VtkLegacyFile.h"
#include "io/formats/vtk/VtkXmlFile.h"
#include "io/reading/Bounds.h"
#include "io/reading/HeaderText.h"
#include "io/reading/PartOfVolume.h"
#include "io/reading/ReadError.h"
#include "scene/basics/SystemReason.h"
#include "scene/volume/Orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string_view>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t probeBytes = 4096;

const Message knownFormats =
    Message::tr("open a DICOM folder, NIfTI, NRRD, MetaImage, VTI or VTK image, a stack "
                "of TIFF, PNG or JPEG pictures, or an InVesalius project");

void requireUsable(const ReadOptions& options) {
  if (options.memory && options.memory->bytes() < MemoryBudget::least)
    throw Error(Error::Kind::usage,
                Message::tr("So little memory is not enough for any volume; give at least %1 MB (--memory).")
                    .arg(MemoryBudget::least / 1'000'000));
  if (!options.spacingMm)
    return;
  for (int axis = 0; axis < 3; ++axis)
    if (!((*options.spacingMm)[axis] > 0.0) || !std::isfinite((*options.spacingMm)[axis]))
      throw Error(Error::Kind::usage,
                  Message::tr("The spacing must be three positive numbers of millimetres."));
}

// The file beside `path` that describes it: the same name with the ending of a header.
std::optional<fs::path> headerBeside(const fs::path& path) {
  for (const char* ending : {".mhd", ".nhdr", ".hdr"}) {
    fs::path candidate = path;
    candidate.replace_extension(ending);
    std::error_code problem;
    if (candidate != path && fs::is_regular_file(candidate, problem))
      return candidate;
  }
  return std::nullopt;
}

// Whether a file starts as texts do, without control characters.
bool isText(std::string_view start) {
  return std::ranges::none_of(start, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && (byte < '\t' || byte > '\r')) || byte == 0x7F;
  });
}

constexpr std::array rawEndings{".raw", ".zraw", ".dat", ".bin"};

// Whether raw voxels lie beside a text of the same name, which then describes them.
bool describesRawVoxels(const fs::path& path, std::string_view start) {
  return isText(start) && std::ranges::any_of(rawEndings, [&](const char* ending) {
           std::error_code ignored;
           return fs::exists(fs::path(path).replace_extension(ending), ignored);
         });
}

[[noreturn]] void failUnknown(const fs::path& path, std::string_view start) {
  const std::string ending = lowerCase(path.extension().string());
  if (const auto header = headerBeside(path))
    failReading(path, Message::tr("it holds voxels without their size"),
                Message::tr("open %1 instead").arg(header->filename().string()));
  if (std::ranges::find(rawEndings, ending) != rawEndings.end() || describesRawVoxels(path, start))
    failReading(
        path, Message::tr("it does not say the size and type of a volume in a way that Limn knows"),
        Message::tr(
            "write a small MetaImage header (.mhd) that names the raw file beside it, and open that"));
  if (ending == ".dcm" || ending == ".dicom" || ending == ".ima")
    failReading(path, Message::tr("it does not start as DICOM does: it is damaged or cut off"), copyAgain);
  if (isText(start))
    failReading(path, Message::tr("it is a text, not a volume"), knownFormats);
  failReading(path, Message::tr("its content is of no known kind"), knownFormats);
}

// A kind of file, told by its content.
struct FileKind {
  bool (*isKind)(std::string_view start); // of the first bytes, inflated where they are packed with gzip
  VolumeParts (*read)(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress);
  bool mayBePacked;
};

VolumeParts readPicture(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
  return readPictures(path, {path}, keeping, progress);
}

constexpr FileKind fileKinds[] = {
    {isNifti, readNifti, true},          {isTar, readInVesalius, true},       {isNrrd, readNrrd, false},
    {isMetaImage, readMetaImage, false}, {isVtkLegacy, readVtkLegacy, false}, {isVtkXml, readVtkXml, false},
    {isPicture, readPicture, true},
};

// The reader of a file is chosen by its content; only the voxel file of a NIfTI pair goes by its name.
VolumeParts readFile(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
  const std::string start = firstBytes(path, probeBytes);
  if (start.empty())
    failReading(path, Message::tr("the file is empty"), copyAgain);
  for (const FileKind& kind : fileKinds)
    if (kind.isKind(start)) {
      if (!kind.mayBePacked && isGzip(path))
        failReading(path, Message::tr("it is packed with gzip"),
                    Message::tr("unpack it and open the file inside"));
      return kind.read(path, keeping, progress);
    }
  const fs::path inner = path.extension() == ".gz" ? path.stem() : path;
  if (lowerCase(inner.extension().string()) == ".img")
    return readNifti(path, keeping, progress);
  failUnknown(path, start);
}

VolumeParts readFolder(const fs::path& path, const VoxelKeeping& keeping, const Progress& progress) {
  const std::vector<fs::path> pictures = picturesIn(path);
  if (pictures.empty())
    failReading(path, Message::tr("the folder holds no DICOM, TIFF, PNG or JPEG slices"),
                Message::tr("open the folder that holds the slices, or a volume file"));
  requireWholeStack(path, pictures);
  return readPictures(path, pictures, keeping, progress);
}

// Applies what the person adds, and says what is not known.
void complete(const fs::path& path, const ReadOptions& options, VolumeParts& parts) {
  VolumeInfo& info = parts.info;
  if (options.spacingMm) {
    parts.grid.spacingMm = *options.spacingMm;
    info.spacingKnown = true;
  }
  if (!info.spacingKnown)
    info.warnings.emplace_back(Message::tr(
        "Spacing unknown: where the file does not give it, 1 mm is assumed; give it with --spacing X,Y,Z."));
  // Its own name and that of the folder it lies in: "head/t1.nii".
  info.hints =
      withHintsOf(withHintsOf(info.hints, path.parent_path().filename().string()), path.filename().string());
  if (!info.orientationKnown)
    info.warnings.emplace_back(orientationUnknown);
  for (Message& warning : info.warnings)
    warning = plainMessage(warning);
  requirePlausible(path, parts.grid);
}

std::shared_ptr<const Volume> finished(const fs::path& path, VolumeParts parts, const Progress& progress) {
  return naming(path, [&] {
    return std::make_shared<const Volume>(parts.grid, std::move(parts.stored), parts.rescale, std::nullopt,
                                          std::move(parts.info), effortOf(progress, countingVoxels),
                                          std::move(parts.room));
  });
}

// The part of a volume that this process holds: of files that stay where they are on the disk, all.
std::shared_ptr<const Volume> partOfVolume(const fs::path& path, VolumeParts parts, const VoxelBox& own,
                                           bool isInSlices, const ReadOptions& options,
                                           const Progress& progress) {
  PartRead read;
  read.grid = parts.grid;
  read.stored = std::move(parts.stored);
  read.rescale = parts.rescale;
  read.info = std::move(parts.info);
  read.room = std::move(parts.room);
  read.held = parts.held.value_or(allVoxels(parts.grid));
  read.own = own;
  read.isInSlices = isInSlices;
  const auto again = [path](const ReadOptions& other) { return readVolume(path, other); };
  return naming(path, [&] {
    return volumeOfPart(std::move(read), options, again, effortOf(progress, countingVoxels));
  });
}

std::shared_ptr<const Volume> readExisting(const fs::path& path, const DicomFolder* dicom,
                                           const ReadOptions& options, const Progress& progress) {
  if (dicom)
    return dicom->read(options, progress);
  const bool isFolder = fs::is_directory(path);
  if (!isFolder && !fs::is_regular_file(path))
    failReading(path, Message::tr("it is no file but a device, pipe or socket"),
                Message::tr("choose a file or folder"));
  VoxelKeeping keeping(options.part ? options.part->memory : options.memory.value_or(MemoryBudget()));
  PartWanted::Share share;
  bool isInSlices = false;
  if (options.part)
    keeping.box = [&](const Grid& grid, bool inSlices) {
      share = options.part->share(grid, inSlices);
      isInSlices = inSlices;
      return share.held;
    };
  const Progress reading = part(progress, 0.0, 0.95), counting = part(progress, 0.95, 1.0);
  VolumeParts parts = isFolder ? readFolder(path, keeping, reading) : readFile(path, keeping, reading);
  complete(path, options, parts);
  return options.part ? partOfVolume(path, std::move(parts), share.own, isInSlices, options, counting)
                      : finished(path, std::move(parts), counting);
}

// Runs a step and turns what may go wrong in it into one sentence for `path`.
template <class Step>
auto reported(const fs::path& path, Step&& step) {
  try {
    return step();
  } catch (const Error& error) {
    throw Error(error.kind(), plainMessage(error.sentence()));
  } catch (const std::bad_alloc&) {
    failReading(path, Message::tr("there is not enough memory for it"),
                Message::tr("close other programs or save a smaller volume"));
  } catch (const std::length_error&) {
    failReading(path, Message::tr("its header asks for more voxels than memory can hold"), copyAgain);
  } catch (const fs::filesystem_error& error) {
    failReading(path, systemReason(error.code().value()),
                Message::tr("check the name and the right to read it"));
  }
}

void requireExisting(const fs::path& path) {
  std::error_code problem;
  if (!fs::exists(path, problem))
    failReading(path, Message::tr("there is no such file or folder"), Message::tr("check the name"));
}

} // namespace

std::shared_ptr<const DicomFolder> dicomAt(const fs::path& path, const Progress& progress) {
  requireExisting(path);
  return reported(path, [&] { return openDicom(path, progress); });
}

void requireWhole(const fs::path& path, const Volume& volume) {
  if (!volume.isWhole())
    failReading(path, Message::tr("it became shorter while it was read, or its disk failed"), copyAgain);
}

std::shared_ptr<const Volume> readVolume(const fs::path& path, const ReadOptions& options,
                                         const Progress& progress) {
  requireUsable(options);
  return readVolume(path, dicomAt(path, progress), options, progress);
}

std::shared_ptr<const Volume> readVolume(const fs::path& path,
                                         const std::shared_ptr<const DicomFolder>& dicom,
                                         const ReadOptions& options, const Progress& progress) {
  requireUsable(options);
  auto volume = reported(path, [&] { return readExisting(path, dicom.get(), options, progress); });
  requireWhole(path, *volume);
  return volume;
}

} // namespace limn
