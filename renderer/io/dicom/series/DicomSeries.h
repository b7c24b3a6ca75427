// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomHeader.h"
#include "io/reading/ReadOptions.h"

namespace limn {

/// One frame of one file. Points into the headers it was made from, which must outlive it.
struct DicomSlice {
  const DicomHeader* header = nullptr;
  int frameIndex = 0;

  const DicomFrame& frame() const { return header->frames[static_cast<std::size_t>(frameIndex)]; }
};

/// Images that can make one volume: one series, size, orientation, spacing and kind of pixel.
using DicomSeries = std::vector<DicomSlice>;

/// Sorts frames into series; those that no volume can be made of come last, otherwise the largest is first.
/// A series found in several folders is one if its parts lie at different positions, several if they repeat
/// each other.
std::vector<DicomSeries> seriesOf(const std::vector<DicomHeader>& headers);

/// What the list of series says of one.
SeriesSummary summaryOf(const DicomSeries& series, int number);

/// Whether every slice says where it lies and how it is turned.
bool isPlaced(const DicomSeries& series);

/// The position of a placed slice along the normal (row × column) of the first of its series, mm.
double distanceMm(const DicomSlice& slice, const DicomSeries& series);

/// Sorts by position along the normal where slices are placed, otherwise by instance number and frame.
DicomSeries sorted(DicomSeries series);

/// The slices of which the volume of a series is made: sorted, without copies, of one phase.
DicomSeries shownOf(const DicomSeries& series, std::vector<Message>& warnings);

} // namespace limn
