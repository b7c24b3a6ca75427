// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomVoxels.h"

#include "io/dicom/pixels/DicomPixelReader.h"
#include "io/dicom/pixels/DicomUnpack.h"
#include "io/reading/Bounds.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

bool isPalette(const DicomHeader& header) {
  return header.format.photometric == "PALETTE COLOR";
}

// An empty array of the narrowest type that holds the stored values of every slice.
VoxelVectors arrayFor(const DicomSeries& series) {
  int bits = 8;
  bool anySigned = false;
  bool anyUnsigned = false;
  for (const DicomSlice& slice : series) {
    const DicomHeader& header = *slice.header;
    bits = std::max(bits, isPalette(header) ? 16 : header.format.bitsAllocated);
    (header.format.isSigned && !isPalette(header) ? anySigned : anyUnsigned) = true;
  }
  if (anySigned && anyUnsigned)
    bits *= 2; // the next wider signed type holds both
  if (bits > 32)
    return RoomVector<double>();
  if (bits == 32)
    return anySigned ? VoxelVectors(RoomVector<std::int32_t>()) : RoomVector<std::uint32_t>();
  if (bits == 16)
    return anySigned ? VoxelVectors(RoomVector<std::int16_t>()) : RoomVector<std::uint16_t>();
  return anySigned ? VoxelVectors(RoomVector<std::int8_t>()) : RoomVector<std::uint8_t>();
}

// The place of slice `index` of `count`. Room is made when a slice arrives: nothing of a picture that does
// not decode is held, whatever its header promises.
template <class T>
T* placeOf(RoomVector<T>& array, std::size_t index, std::size_t count, std::size_t perSlice) {
  array.reserve(count * perSlice);
  array.resize(std::max(array.size(), (index + 1) * perSlice));
  return array.data() + index * perSlice;
}

Rescale rescaleOf(const DicomSlice& slice) {
  return slice.frame().rescale.value_or(Rescale{});
}

bool isUsable(const Rescale& rescale) {
  return rescale.slope != 0.0 && std::isfinite(rescale.slope) && std::isfinite(rescale.intercept);
}

bool haveOneMeaning(const DicomSlice& a, const DicomSlice& b) {
  const auto& p = a.header->padding;
  const auto& q = b.header->padding;
  const bool samePadding =
      p.has_value() == q.has_value() && (!p || (p->first == q->first && p->last == q->last));
  return rescaleOf(a) == rescaleOf(b) && samePadding;
}

// Whether one linear rescale and one padding hold for the whole volume.
bool keepsStoredValues(const DicomSeries& series) {
  return std::ranges::all_of(series, [&](const DicomSlice& slice) {
    return !slice.header->modalityLut && haveOneMeaning(slice, series.front());
  });
}

float modalityValue(const DicomSlice& slice, double stored) {
  const auto& padding = slice.header->padding;
  if (padding && stored >= padding->first && stored <= padding->last)
    return std::numeric_limits<float>::quiet_NaN();
  if (const auto& lut = slice.header->modalityLut)
    return static_cast<float>(lut->valueOf(stored));
  const Rescale rescale = rescaleOf(slice);
  return static_cast<float>(rescale.slope * stored + rescale.intercept);
}

// What is to be said of the voxels.
struct DicomReadNotes {
  DicomUnpackNotes unpacking;
  std::vector<Message>& warnings;
};

// Reads all slices in an order that opens each file once, and hands each raw frame to `use`.
template <class Use>
void forEachFrame(const DicomSeries& series, const Progress& progress, Use&& use) {
  std::vector<std::size_t> order(series.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return std::less<>()(series[a].header, series[b].header); });
  std::optional<DicomPixelReader> reader;
  const DicomHeader* open = nullptr;
  for (std::size_t done = 0; done < order.size(); ++done) {
    reportOrStop(progress, static_cast<double>(done) / static_cast<double>(order.size()),
                 Message::tr("Reading slices"));
    const DicomSlice& slice = series[order[done]];
    if (slice.header != open)
      reader.emplace(*slice.header);
    open = slice.header;
    use(order[done], slice, reader->frame(slice.frameIndex));
  }
}

// An empty array where the voxels of a series have their place.
template <class T>
RoomVector<T> kept(const DicomKeeping& keeping, std::size_t voxels, std::vector<Message>& warnings) {
  std::vector<Message> untold;
  return RoomVector<T>(roomFor(keeping.path, static_cast<double>(voxels) * sizeof(T), keeping.budget,
                               keeping.isPassing ? untold : warnings));
}

DicomVoxels readStored(const DicomSeries& series, std::size_t perSlice, const DicomKeeping& keeping,
                       const Progress& progress, DicomReadNotes& notes) {
  DicomVoxels voxels{arrayFor(series), rescaleOf(series.front()), series.front().header->padding, nullptr};
  std::visit(
      [&](auto& array) {
        using Value = typename std::decay_t<decltype(array)>::value_type;
        array = kept<Value>(keeping, perSlice * series.size(), notes.warnings);
        voxels.room = array.get_allocator().room();
        if constexpr (!std::is_same_v<Value, float>)
          forEachFrame(series, progress, [&](std::size_t index, const DicomSlice& slice, const auto& raw) {
            unpackFrame(*slice.header, raw, placeOf(array, index, series.size(), perSlice), notes.unpacking);
          });
      },
      voxels.stored);
  return voxels;
}

DicomVoxels readModalityValues(const DicomSeries& series, std::size_t perSlice, const DicomKeeping& keeping,
                               const Progress& progress, DicomReadNotes& notes) {
  auto values = kept<float>(keeping, perSlice * series.size(), notes.warnings);
  std::vector<double> stored(perSlice);
  forEachFrame(series, progress, [&](std::size_t index, const DicomSlice& slice, const DicomRawFrame& raw) {
    unpackFrame(*slice.header, raw, stored.data(), notes.unpacking);
    std::ranges::transform(stored, placeOf(values, index, series.size(), perSlice),
                           [&](double value) { return modalityValue(slice, value); });
  });
  const std::shared_ptr<Room> room = values.get_allocator().room();
  return {std::move(values), Rescale{}, std::nullopt, room};
}

Message ratioText(const std::optional<double>& ratio) {
  return ratio ? Message::tr(" (%1 : 1)").arg(Message::rounded(*ratio, 3)) : Message();
}

bool holdsMoreThanAnnounced(const DicomSlice& slice) {
  const DicomHeader& header = *slice.header;
  return !header.pixels->isEncapsulated &&
         header.pixels->length >= frameBytes(header) * (header.announcedFrames + 1);
}

void noteFormat(const DicomSeries& series, std::vector<Message>& warnings) {
  const DicomHeader& first = *series.front().header;
  const auto lossy =
      std::ranges::find_if(series, [](const DicomSlice& slice) { return slice.header->isLossy; });
  if (lossy != series.end())
    warnings.push_back(
        Message::tr(
            "The images were compressed with loss%1: fine detail differs from what the scanner measured.")
            .arg(ratioText(lossy->header->lossyRatio)));
  if (std::ranges::any_of(series, holdsMoreThanAnnounced))
    warnings.emplace_back(
        Message::tr("The file holds more pixels than its header announces; the rest is not shown."));
  if (first.format.photometric == "MONOCHROME1")
    warnings.emplace_back(Message::tr(
        "The images are meant to be shown inverted (MONOCHROME1); their values are kept as they are."));
  if (first.format.samples > 1 || isPalette(first))
    warnings.emplace_back(Message::tr("The images are coloured; their luminance is shown."));
}

} // namespace

DicomVoxels readVoxels(const DicomSeries& series, const DicomKeeping& keeping, const Progress& progress,
                       std::vector<Message>& warnings) {
  const DicomHeader& first = *series.front().header;
  for (const DicomSlice& slice : series)
    if (!isUsable(rescaleOf(slice)))
      throw Error(Error::Kind::input,
                  Message::tr("The DICOM file %1 gives a rescale slope of 0 or none that is a number, which "
                              "leaves no values; its header is damaged.")
                      .arg(slice.header->path.string()));
  const auto perSlice = static_cast<std::size_t>(first.columns) * static_cast<std::size_t>(first.rows);
  DicomReadNotes notes{{}, warnings};
  noteFormat(series, warnings);
  DicomVoxels voxels = keepsStoredValues(series)
                           ? readStored(series, perSlice, keeping, progress, notes)
                           : readModalityValues(series, perSlice, keeping, progress, notes);
  if (notes.unpacking.ignoredBits)
    warnings.emplace_back(
        Message::tr("Some pixels have bits set beyond those that hold the value; these bits were ignored."));
  return voxels;
}

} // namespace limn
