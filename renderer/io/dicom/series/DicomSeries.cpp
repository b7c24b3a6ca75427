// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/series/DicomSeries.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace limn {
namespace {

// Files write direction cosines with as few as four digits.
constexpr double sameDirection = 1e-3;
constexpr double sameSpacing = 1e-3;

bool haveOneOrientation(const DicomFrame& a, const DicomFrame& b) {
  if (a.axes.has_value() != b.axes.has_value() || a.positionMm.has_value() != b.positionMm.has_value())
    return false;
  return !a.axes || (glm::length((*a.axes)[0] - (*b.axes)[0]) < sameDirection &&
                     glm::length((*a.axes)[1] - (*b.axes)[1]) < sameDirection);
}

bool haveOneSpacing(const DicomFrame& a, const DicomFrame& b) {
  if (a.pixelSpacingMm.has_value() != b.pixelSpacingMm.has_value())
    return false;
  return !a.pixelSpacingMm ||
         glm::length(*a.pixelSpacingMm - *b.pixelSpacingMm) < sameSpacing * glm::length(*a.pixelSpacingMm);
}

bool makeOneVolume(const DicomSlice& a, const DicomSlice& b) {
  // Several frames without positions are a whole of their own.
  const bool isStack = a.header->frames.size() > 1 && !a.frame().positionMm;
  if (isStack && a.header != b.header)
    return false;
  const auto facts = [](const DicomHeader& h) {
    return std::tie(h.seriesInstance, h.studyInstance, h.columns, h.rows, h.format.samples,
                    h.format.photometric);
  };
  return facts(*a.header) == facts(*b.header) && a.frame().stackId == b.frame().stackId &&
         haveOneOrientation(a.frame(), b.frame()) && haveOneSpacing(a.frame(), b.frame());
}

bool canBecomeVolume(const DicomSeries& series) {
  try {
    requireSupported(*series.front().header);
    return true;
  } catch (const Error&) {
    return false;
  }
}

// Whether two parts of one volume found in different folders complement each other.
bool complement(const DicomSeries& a, const DicomSeries& b) {
  if (!isPlaced(a) || !isPlaced(b))
    return false;
  const double tolerance = sameDistanceMm(a);
  std::vector<double> distances;
  for (const DicomSlice& slice : a)
    distances.push_back(distanceMm(slice, a));
  std::sort(distances.begin(), distances.end());
  return std::none_of(b.begin(), b.end(), [&](const DicomSlice& slice) {
    const double distance = distanceMm(slice, a);
    const auto near = std::lower_bound(distances.begin(), distances.end(), distance - tolerance);
    return near != distances.end() && *near <= distance + tolerance;
  });
}

std::vector<DicomSeries> merged(std::vector<DicomSeries> parts) {
  std::vector<DicomSeries> whole;
  for (DicomSeries& part : parts) {
    const auto found = std::find_if(whole.begin(), whole.end(), [&](const DicomSeries& other) {
      return makeOneVolume(other.front(), part.front()) &&
             other.front().header->path.parent_path() != part.front().header->path.parent_path() &&
             complement(other, part);
    });
    if (found == whole.end())
      whole.push_back(std::move(part));
    else
      found->insert(found->end(), part.begin(), part.end());
  }
  return whole;
}

} // namespace

std::vector<DicomSeries> seriesOf(const std::vector<DicomHeader>& headers) {
  std::vector<DicomSeries> parts;
  for (const DicomHeader& header : headers)
    for (std::size_t i = 0; i < header.frames.size(); ++i) {
      const DicomSlice slice{&header, static_cast<int>(i)};
      // Files of a series mostly follow each other, so look at the newest part first.
      const auto found = std::find_if(parts.rbegin(), parts.rend(), [&](const DicomSeries& part) {
        return makeOneVolume(part.front(), slice) &&
               part.front().header->path.parent_path() == header.path.parent_path();
      });
      if (found == parts.rend())
        parts.push_back({slice});
      else
        found->push_back(slice);
    }
  std::vector<DicomSeries> all = merged(std::move(parts));
  const auto rank = [](const DicomSeries& series) {
    const DicomHeader& first = *series.front().header;
    const double voxels =
        static_cast<double>(first.columns) * first.rows * static_cast<double>(series.size());
    return std::tuple(!canBecomeVolume(series), -voxels, first.seriesNumber.value_or(0.0));
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const DicomSeries& a, const DicomSeries& b) { return rank(a) < rank(b); });
  return all;
}

SeriesSummary summaryOf(const DicomSeries& series, int number) {
  const DicomHeader& first = *series.front().header;
  return {.number = number,
          .description = first.seriesDescription,
          .modality = first.modality,
          .dims = {first.columns, first.rows, static_cast<int>(series.size())},
          .thicknessMm = series.front().frame().thicknessMm,
          .date = first.patient.studyDate,
          .folder = {}};
}

bool isPlaced(const DicomSeries& series) {
  return std::all_of(series.begin(), series.end(), [](const DicomSlice& slice) {
    return slice.frame().positionMm.has_value() && slice.frame().axes.has_value();
  });
}

double distanceMm(const DicomSlice& slice, const DicomSeries& series) {
  const auto& axes = *series.front().frame().axes;
  return glm::dot(*slice.frame().positionMm, glm::cross(axes[0], axes[1]));
}

double sameDistanceMm(const DicomSeries& series) {
  const glm::dvec2 spacing = series.front().frame().pixelSpacingMm.value_or(glm::dvec2(1.0));
  return 0.01 * std::min({spacing.x, spacing.y, 1.0});
}

DicomSeries sorted(DicomSeries series) {
  const bool usePosition = isPlaced(series);
  const DicomSeries reference = series;
  const auto key = [&](const DicomSlice& slice) {
    return std::tuple(usePosition ? distanceMm(slice, reference) : 0.0,
                      slice.header->instanceNumber.value_or(std::numeric_limits<double>::max()),
                      std::cref(slice.header->path.native()), slice.frameIndex);
  };
  std::stable_sort(series.begin(), series.end(), [&](const DicomSlice& a, const DicomSlice& b) {
    const auto left = key(a);
    const auto right = key(b);
    return std::tie(std::get<0>(left), std::get<1>(left), std::get<2>(left).get(), std::get<3>(left)) <
           std::tie(std::get<0>(right), std::get<1>(right), std::get<2>(right).get(), std::get<3>(right));
  });
  return series;
}

} // namespace limn
