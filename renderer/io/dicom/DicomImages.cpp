// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomImages.h"

#include "io/dicom/DicomReader.h"
#include "io/dicom/series/DicomScan.h"
#include "io/dicom/series/DicomSeries.h"

#include <set>

namespace limn {

std::vector<SeriesImages> imagesUnder(const std::filesystem::path& path, const Progress& progress) {
  if (!isDicom(path))
    return {};
  const DicomScan scan = scanDicom(path, progress);
  std::vector<SeriesImages> all;
  for (const DicomSeries& series : seriesOf(scan.images)) {
    std::vector<Message> said; // by the reader, where the series is read
    const DicomSeries shown = shownOf(series, said);
    const DicomHeader& first = *shown.front().header;
    SeriesImages images{
        static_cast<int>(all.size()) + 1, first.studyInstance, first.seriesInstance, {}, first.path};
    std::set<const DicomHeader*> listed; // a file may hold many slices
    for (const DicomSlice& slice : shown)
      if (listed.insert(slice.header).second)
        images.images.push_back({slice.header->sopClass, slice.header->sopInstance});
    for (const DicomSlice& slice : series)
      if (listed.insert(slice.header).second)
        images.leftOut.push_back(slice.header->sopInstance);
    all.push_back(std::move(images));
  }
  return all;
}

} // namespace limn
