// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomScan.h"

#include "scene/Error.h"

#include <algorithm>

namespace limn {
namespace {

constexpr std::size_t mostFiles = 50000;
constexpr int deepestFolder = 8;

const std::string dicomDirClass = "1.2.840.10008.1.3.10";

void addFile(const std::filesystem::path& path, DicomScan& scan) {
  try {
    DicomHeader header = headerOf(path, parseDicom(path));
    if (header.pixels)
      scan.images.push_back(std::move(header));
    else
      ++scan.withoutImage;
  } catch (const Error&) {
    if (++scan.damaged == 1)
      scan.firstDamaged = path.filename().string();
  }
}

} // namespace

std::vector<std::filesystem::path> filesUnder(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry.depth() >= deepestFolder)
      entry.disable_recursion_pending();
    if (entry->is_regular_file(ignored))
      files.push_back(entry->path());
    if (files.size() > mostFiles)
      throw Error(Error::Kind::input, "The folder " + folder.string() + " holds more than " +
                                          std::to_string(mostFiles) +
                                          " files; open the folder of one study instead.");
  }
  if (error)
    throw Error(Error::Kind::input,
                "The folder " + folder.string() + " cannot be read (" + error.message() + ").");
  std::sort(files.begin(), files.end());
  return files;
}

DicomScan scanDicom(const std::filesystem::path& path, const Progress& progress) {
  DicomScan scan;
  if (!std::filesystem::is_directory(path)) {
    DicomHeader header = headerOf(path, parseDicom(path));
    if (header.sopClass == dicomDirClass)
      return scanDicom(std::filesystem::absolute(path).parent_path(), progress);
    scan.images.push_back(std::move(header));
    return scan;
  }
  const std::vector<std::filesystem::path> files = filesUnder(path);
  for (std::size_t i = 0; i < files.size(); ++i) {
    reportOrStop(progress, static_cast<double>(i) / static_cast<double>(files.size()), "Reading headers");
    if (startsAsDicom(files[i]))
      addFile(files[i], scan);
  }
  return scan;
}

void reportOrStop(const Progress& progress, double fraction, const std::string& what) {
  if (progress.isCancelled && progress.isCancelled())
    throw Cancelled();
  if (progress.report)
    progress.report(fraction, what);
}

} // namespace limn
