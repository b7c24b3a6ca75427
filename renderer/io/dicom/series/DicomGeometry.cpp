// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/series/DicomGeometry.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double largestEvenness = 0.05;    // of the median distance: averaged up to here
constexpr double smallestUnevenness = 1e-3; // of the median: below, positions were only rounded
constexpr double largestDisplacement = 0.5; // of the spacing: a slice averaging may move so far
constexpr double largestBridge = 4.0;       // of the median distance: a longer gap is not interpolated
constexpr double unnoticed = 0.1;           // pixels a slice may be shifted sideways: rounding
constexpr double straight = 0.5;            // pixels: up to here stacked with a warning, beyond resampled
constexpr std::size_t mostRefinement = 4;   // how many planes may be made of one slice

Message decimal(double value, int digits = 3) {
  return Message::fixed(value, digits);
}

struct Spacing {
  double mm = 1.0;
  int planes = 1;
  bool isEven = true;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Says how far averaging moves a slice at most.
double displacement(const std::vector<double>& heights, double spacing) {
  double largest = 0.0;
  for (std::size_t k = 0; k < heights.size(); ++k)
    largest = std::max(largest, std::abs(heights[k] - spacing * static_cast<double>(k)));
  return largest;
}

void refuseGap(const std::vector<double>& gaps, double usual) {
  const auto widest = std::max_element(gaps.begin(), gaps.end());
  if (*widest > largestBridge * usual)
    throw Error(Error::Kind::input,
                Message::tr("The DICOM series has a gap of %1 mm after slice %2, where its slices usually "
                            "lie %3 mm apart: slices are missing; copy the whole series again.")
                    .arg(decimal(*widest), widest - gaps.begin() + 1, decimal(usual)));
}

// Says where slices must be missing: in gaps that are whole multiples of the usual distance. Empty where
// no gap is.
Message missingSlices(const std::vector<double>& heights, double usual) {
  constexpr double wholeness = 0.15; // of the distance: as even as slices of a complete series commonly are
  constexpr std::size_t mostNamed = 3;
  std::size_t missing = 0;
  std::size_t places = 0;
  Message where;
  for (std::size_t k = 1; k < heights.size(); ++k) {
    const double steps = (heights[k] - heights[k - 1]) / usual;
    const double whole = std::round(steps);
    if (whole < 2.0 || std::abs(steps - whole) > wholeness)
      continue;
    missing += static_cast<std::size_t>(whole) - 1;
    if (++places <= mostNamed)
      where = where.followedBy(
          ", ", Message::tr("%1 and %2 mm").arg(decimal(heights[k - 1], 1), decimal(heights[k], 1)));
  }
  if (places == 0)
    return {};
  if (places > mostNamed)
    where = Message::tr("%1 and in %2 more places").arg(where, places - mostNamed);
  return (missing == 1 ? Message::tr("%1 slice seems to be missing between %2 from the first")
                       : Message::tr("%1 slices seem to be missing between %2 from the first"))
      .arg(missing, where);
}

// Chooses the distance of the grid's planes for slices at the given heights (ascending from 0).
Spacing planeSpacing(const std::vector<double>& heights, std::vector<Message>& warnings) {
  const auto slices = heights.size();
  std::vector<double> gaps;
  for (std::size_t k = 1; k < slices; ++k)
    gaps.push_back(heights[k] - heights[k - 1]);
  const double usual = median(gaps);
  const double smallest = *std::min_element(gaps.begin(), gaps.end());
  const double widest = *std::max_element(gaps.begin(), gaps.end());
  const double mean = heights.back() / static_cast<double>(slices - 1);
  const double unevenness = std::max(widest - usual, usual - smallest) / usual;
  const double moved = displacement(heights, mean);
  const Message range = Message::tr("%1 to %2 mm").arg(decimal(smallest), decimal(widest));
  if (unevenness <= largestEvenness && moved <= largestDisplacement * mean) {
    if (unevenness > smallestUnevenness)
      warnings.push_back(
          Message::tr("The slices lie %1 apart; %2 mm is used for all, which moves a slice by %3 mm at most.")
              .arg(range, decimal(mean), decimal(moved)));
    return {mean, static_cast<int>(slices), true};
  }
  refuseGap(gaps, usual);
  const bool refines = heights.back() / smallest < static_cast<double>(mostRefinement * slices);
  const int planes = static_cast<int>(std::lround(heights.back() / (refines ? smallest : usual))) + 1;
  const double spacing = heights.back() / (planes - 1);
  const Message missing = missingSlices(heights, usual);
  warnings.push_back(Message::tr("The slices lie unequally, %1 apart: %2 planes every %3 mm were "
                                 "interpolated between them, some of which %4")
                         .arg(range, planes, decimal(spacing),
                              missing.empty() ? Message::tr("may bridge missing slices.")
                                              : Message::tr("bridge missing slices: %1.").arg(missing)));
  return {spacing, planes, false};
}

// How far the first pixel of each slice lies sideways from that of the first slice, in pixels.
std::vector<DicomPlacement> placementsOf(const DicomSeries& series, const glm::dmat3& direction,
                                         const glm::dvec2& spacing) {
  std::vector<DicomPlacement> placements;
  const glm::dvec3 first = *series.front().frame().positionMm;
  for (const DicomSlice& slice : series) {
    const glm::dvec3 offset = *slice.frame().positionMm - first;
    placements.push_back(
        {glm::dot(offset, direction[2]),
         glm::dvec2(glm::dot(offset, direction[0]) / spacing.x, glm::dot(offset, direction[1]) / spacing.y)});
  }
  return placements;
}

// Widens the grid by whole pixels until it holds every shifted slice.
void holdShiftedSlices(DicomGeometry& geometry, std::vector<Message>& warnings) {
  Grid& grid = geometry.grid;
  glm::dvec2 lowest(0.0);
  glm::dvec2 highest(0.0);
  for (const DicomPlacement& placement : geometry.placements) {
    lowest = glm::min(lowest, placement.shift);
    highest = glm::max(highest, placement.shift);
  }
  const double sideways = std::max({highest.x, -lowest.x, highest.y, -lowest.y});
  if (sideways <= straight) {
    if (sideways > unnoticed)
      warnings.push_back(
          Message::tr("The slices are stacked straight although they lie up to %1 mm sideways of each other.")
              .arg(decimal(sideways * std::max(grid.spacingMm.x, grid.spacingMm.y))));
    for (DicomPlacement& placement : geometry.placements)
      placement.shift = glm::dvec2(0.0);
    return;
  }
  const glm::dvec2 widening = glm::ceil(highest) - glm::floor(lowest);
  if (!(widening.x <= grid.dims.x) || !(widening.y <= grid.dims.y))
    throw Error(Error::Kind::input,
                Message::tr("The slices of the DICOM series lie beside each other rather than on each other, "
                            "so they make no volume; choose another series."));
  const DicomPlacement& last = geometry.placements.back();
  const glm::dvec2 drift = last.shift * glm::dvec2(grid.spacingMm);
  const double angle = glm::degrees(std::atan2(glm::length(drift), last.heightMm));
  const glm::ivec2 start(glm::floor(lowest));
  const glm::ivec2 extra(widening);
  warnings.insert(warnings.begin(),
                  Message::tr("The slices slant by %1°, as of a tilted gantry, and were resampled upright.")
                      .arg(decimal(angle, 1)));
  warnings.emplace_back(
      Message::tr("The corners that the upright grid adds beside its slices hold no data."));
  grid.dims += glm::ivec3(extra, 0);
  grid.originMm += grid.direction * (grid.spacingMm * glm::dvec3(start, 0.0));
  for (DicomPlacement& placement : geometry.placements)
    placement.shift -= glm::dvec2(start);
  geometry.needsResampling = true;
  geometry.slants = true;
}

// The distance between planes where no positions tell it.
double statedSpacing(const DicomSeries& series, DicomGeometry& geometry, bool isGiven,
                     std::vector<Message>& warnings) {
  const DicomFrame& frame = series.front().frame();
  const auto stated = series.size() == 1
                          ? (frame.thicknessMm ? frame.thicknessMm : frame.betweenSlicesMm)
                          : (frame.betweenSlicesMm ? frame.betweenSlicesMm : frame.thicknessMm);
  if (!stated && !isGiven) {
    geometry.spacingKnown = false;
    warnings.emplace_back(Message::tr("The series does not say how thick its slices are; 1 mm is assumed."));
  }
  return stated.value_or(1.0);
}

void readPixelSpacing(const DicomSeries& series, DicomGeometry& geometry, bool isGiven,
                      std::vector<Message>& warnings) {
  const auto spacing = series.front().frame().pixelSpacingMm;
  if (!spacing && !isGiven) {
    geometry.spacingKnown = false;
    warnings.emplace_back(Message::tr("The series does not say how large its pixels are; 1 mm is assumed."));
  }
  geometry.grid.spacingMm = glm::dvec3(spacing.value_or(glm::dvec2(1.0)), 1.0);
}

DicomGeometry unplaced(DicomGeometry geometry, const DicomSeries& series, bool isGiven,
                       std::vector<Message>& warnings) {
  geometry.orientationKnown = false;
  geometry.grid.spacingMm.z = statedSpacing(series, geometry, isGiven, warnings);
  warnings.emplace_back(
      series.size() == 1
          ? Message::tr("The image does not say where it lies in the patient; its orientation is unknown.")
          : Message::tr("The images do not say where they lie in the patient: they are stacked in the order "
                        "of their numbers, and the orientation is unknown."));
  return geometry;
}

} // namespace

DicomGeometry geometryOf(const DicomSeries& series, bool spacingIsGiven, std::vector<Message>& warnings) {
  const DicomHeader& header = *series.front().header;
  DicomGeometry geometry;
  geometry.grid.dims = {header.columns, header.rows, static_cast<int>(series.size())};
  readPixelSpacing(series, geometry, spacingIsGiven, warnings);
  if (!isPlaced(series))
    return unplaced(std::move(geometry), series, spacingIsGiven, warnings);

  Grid& grid = geometry.grid;
  const auto& axes = *series.front().frame().axes;
  grid.direction = glm::dmat3(axes[0], axes[1], glm::cross(axes[0], axes[1]));
  grid.originMm = *series.front().frame().positionMm;
  if (series.size() == 1) {
    grid.spacingMm.z = statedSpacing(series, geometry, spacingIsGiven, warnings);
    return geometry;
  }
  geometry.placements = placementsOf(series, grid.direction, glm::dvec2(grid.spacingMm));
  std::vector<double> heights;
  for (const DicomPlacement& placement : geometry.placements)
    heights.push_back(placement.heightMm);
  const Spacing spacing = planeSpacing(heights, warnings);
  grid.spacingMm.z = spacing.mm;
  grid.dims.z = spacing.planes;
  geometry.needsResampling = !spacing.isEven;
  if (spacing.isEven)
    for (std::size_t k = 0; k < series.size(); ++k)
      geometry.placements[k].heightMm = spacing.mm * static_cast<double>(k);
  holdShiftedSlices(geometry, warnings);
  return geometry;
}

} // namespace limn
