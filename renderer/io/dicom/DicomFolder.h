// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/series/DicomSeries.h"
#include "io/reading/Progress.h"
#include "io/reading/ReadOptions.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace limn {

/// An image by what other objects call it.
struct DicomReference {
  std::string sopClass;
  std::string sopInstance;
  auto operator<=>(const DicomReference&) const = default;
};

/// The images that the volume of a series is made of.
struct SeriesImages {
  int number = 0; ///< as `summaries` gives it
  std::string study;
  std::string series;
  std::vector<DicomReference> images; ///< each once, in the order of the slices
  std::filesystem::path firstFile;    ///< the file of the first of them
  /// Instances of the series that the volume is not made of: other phases.
  std::vector<std::string> leftOut = {};
};

/// What the headers under a path say.
struct DicomHeaders {
  std::vector<DicomHeader> images;
  int withoutImage = 0; ///< DICOM objects that hold no image: reports, plans, indices
  /// The names of files that must have been images: those whose header cannot be read or ends before the
  /// picture, and those that do not start as DICOM but are called as the images are.
  std::vector<std::string> damaged;
  std::vector<std::filesystem::path> states; ///< files of presentation states: how others show images
};

/// A DICOM file, or a folder of such files and those below it, of which every header has been read, once. A
/// file is opened once more for its pixels, where its series is read.
class DicomFolder {
public:
  DicomFolder(std::filesystem::path path, DicomHeaders headers);
  DicomFolder(const DicomFolder&) = delete; // series point into the headers
  DicomFolder& operator=(const DicomFolder&) = delete;

  /// As it was opened.
  const std::filesystem::path& path() const { return m_path; }

  /// The series, largest first.
  std::vector<SeriesSummary> summaries() const;

  /// The images of each series in that order, without copies and of the phase that is shown.
  std::vector<SeriesImages> images() const;

  const std::vector<std::filesystem::path>& states() const { return m_headers.states; }

  /// Reads the volume of a series: the DICOM part of readVolume, with the same contract, and the last 0.7 of
  /// its progress.
  std::shared_ptr<const Volume> read(const ReadOptions& options, const Progress& progress) const;

private:
  std::filesystem::path m_path;
  DicomHeaders m_headers;
  std::vector<DicomSeries> m_series;
};

/// Reads the headers of a file or of all DICOM files under a folder; for a DICOMDIR, under the folder that
/// holds it. Null where the file, or none of the first two thousand of the folder, starts as DICOM: content
/// decides, never names. Links to folders are not followed, and folders of the kernel such as /proc not
/// entered. Reports the first 0.3 of reading a volume. Throws Error (input) where a single file is damaged or
/// a folder holds more files than a study ever does; Cancelled, soon however many files there are.
std::shared_ptr<const DicomFolder> openDicom(const std::filesystem::path& path, const Progress& progress);

} // namespace limn
