// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/series/DicomScan.h"

#include "io/reading/NameLikeness.h"
#include "io/reading/ReadError.h"

#include <sys/vfs.h>

#include <algorithm>
#include <array>
#include <set>

namespace limn {
namespace {

constexpr std::size_t mostFiles = 50000;
constexpr int deepestFolder = 8;

const std::string dicomDirClass = "1.2.840.10008.1.3.10";

// What is known of the files of a folder while it is looked through.
struct Findings {
  DicomScan scan;
  std::vector<DicomHeader> withoutPicture;
  std::vector<std::filesystem::path> foreign; ///< they do not start as DICOM
  std::vector<std::filesystem::path> damaged;
};

void addFile(const std::filesystem::path& path, Findings& found) {
  try {
    DicomHeader header = headerOf(path, parseDicom(path));
    if (header.pixels)
      found.scan.images.push_back(std::move(header));
    else if (hasLostPicture(header))
      found.damaged.push_back(path);
    else
      found.withoutPicture.push_back(std::move(header));
  } catch (const Error&) {
    found.damaged.push_back(path);
  }
}

bool hasDicomEnding(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  const std::string name = path.filename().string();
  return name.front() != '.' &&
         (ending == ".dcm" || ending == ".DCM" || ending == ".dicom" || ending == ".ima" || ending == ".IMA");
}

// What the images tell of the other files: which names slices have, and which kinds hold pictures.
DicomScan judged(Findings found) {
  NameLikeness names;
  std::set<std::string> classes;
  for (const DicomHeader& image : found.scan.images) {
    names.add(image.path);
    classes.insert(image.sopClass);
  }
  for (const DicomHeader& header : found.withoutPicture)
    if (classes.contains(header.sopClass))
      found.damaged.push_back(header.path);
    else
      ++found.scan.withoutImage;
  for (const std::filesystem::path& file : found.foreign)
    if (names.isLike(file) || hasDicomEnding(file))
      found.damaged.push_back(file);
  std::sort(found.damaged.begin(), found.damaged.end());
  for (const std::filesystem::path& file : found.damaged)
    found.scan.damaged.push_back(file.filename().string());
  return std::move(found.scan);
}

} // namespace

std::vector<std::filesystem::path> filesUnder(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry.depth() >= deepestFolder || (entry->is_directory(ignored) && isPseudoFolder(entry->path())))
      entry.disable_recursion_pending();
    if (entry->is_regular_file(ignored))
      files.push_back(entry->path());
    if (files.size() > mostFiles)
      throw Error(Error::Kind::input,
                  Message::tr("The folder %1 holds more than %2 files; open the folder of one study instead.")
                      .arg(folder.string())
                      .arg(mostFiles));
  }
  if (error)
    failReading(folder, error.message(), Message::tr("check the name and the right to read it"));
  std::sort(files.begin(), files.end());
  return files;
}

DicomScan scanDicom(const std::filesystem::path& path, const Progress& progress) {
  Findings found;
  if (!std::filesystem::is_directory(path)) {
    DicomHeader header = headerOf(path, parseDicom(path));
    if (header.sopClass == dicomDirClass)
      return scanDicom(std::filesystem::absolute(path).parent_path(), progress);
    found.scan.images.push_back(std::move(header));
    return std::move(found.scan);
  }
  const std::vector<std::filesystem::path> files = filesUnder(path);
  for (std::size_t i = 0; i < files.size(); ++i) {
    reportOrStop(progress, static_cast<double>(i) / static_cast<double>(files.size()),
                 Message::tr("Reading headers"));
    if (startsAsDicom(files[i]))
      addFile(files[i], found);
    else
      found.foreign.push_back(files[i]);
  }
  return judged(std::move(found));
}

bool isPseudoFolder(const std::filesystem::path& folder) {
  // Linux, include/uapi/linux/magic.h: proc, sysfs, debugfs, tracefs, cgroup, cgroup2, securityfs, selinuxfs,
  // bpf, configfs, pstore, efivarfs, binfmt_misc.
  constexpr std::array<unsigned, 13> magics = {0x9fa0,     0x62656572, 0x64626720, 0x74726163, 0x27e0eb,
                                               0x63677270, 0x73636673, 0xf97cff8c, 0xcafe4a11, 0x62656570,
                                               0x6165676c, 0xde5e81e4, 0x42494e4d};
  struct statfs facts {};
  return statfs(folder.c_str(), &facts) == 0 &&
         std::find(magics.begin(), magics.end(), static_cast<unsigned>(facts.f_type)) != magics.end();
}

} // namespace limn
