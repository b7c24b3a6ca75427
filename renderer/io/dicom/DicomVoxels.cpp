// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/DicomVoxels.h"

#include "io/dicom/pixels/DicomPixelReader.h"
#include "io/reading/Bounds.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

std::size_t pixelsOf(const DicomHeader& header) {
  return static_cast<std::size_t>(header.columns) * static_cast<std::size_t>(header.rows);
}

std::size_t areaOf(const VoxelBox& box) {
  const glm::ivec3 size = box.upper - box.lower;
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

std::size_t slicesOf(const VoxelBox& box) {
  return static_cast<std::size_t>(box.upper.z - box.lower.z);
}

// What a box keeps of a slice.
template <class T>
void keepRows(const std::vector<T>& slice, int columns, const VoxelBox& box, T* to) {
  for (int y = box.lower.y; y < box.upper.y; ++y)
    to = std::copy_n(slice.data() + voxelOffset({columns, 0, 0}, box.lower.x, y, 0),
                     box.upper.x - box.lower.x, to);
}

// What is to be said of the voxels.
struct DicomReadNotes {
  DicomUnpackNotes unpacking;
  std::vector<Message>& warnings;
};

// Reads the slices of a box in an order that opens each file once, and hands each raw frame to `use` with its
// place among those slices.
template <class Use>
void forEachFrame(const DicomSeries& series, const VoxelBox& box, const Progress& progress, Use&& use) {
  const auto first = static_cast<std::size_t>(box.lower.z);
  std::vector<std::size_t> order(slicesOf(box));
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = first + i;
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
    use(order[done] - first, slice, reader->frame(slice.frameIndex));
  }
}

// An empty array where the voxels of a series have their place.
template <class T>
RoomVector<T> kept(const DicomKeeping& keeping, std::size_t voxels, std::vector<Message>& warnings) {
  std::vector<Message> untold;
  return RoomVector<T>(roomFor(keeping.path, static_cast<double>(voxels) * sizeof(T), keeping.budget,
                               keeping.isPassing ? untold : warnings));
}

DicomVoxels readStored(const DicomSeries& series, const VoxelBox& box, const DicomKeeping& keeping,
                       const Progress& progress, DicomReadNotes& notes) {
  const std::size_t perSlice = areaOf(box), slices = slicesOf(box);
  DicomVoxels voxels{arrayFor(series), rescaleOf(series.front()), series.front().header->padding, nullptr,
                     false};
  std::visit(
      [&](auto& array) {
        using Value = typename std::decay_t<decltype(array)>::value_type;
        array = kept<Value>(keeping, perSlice * slices, notes.warnings);
        voxels.room = array.get_allocator().room();
        std::vector<Value> whole;
        if constexpr (!std::is_same_v<Value, float>)
          forEachFrame(series, box, progress,
                       [&](std::size_t index, const DicomSlice& slice, const auto& raw) {
                         if (perSlice == pixelsOf(*slice.header))
                           return unpackFrame(*slice.header, raw, placeOf(array, index, slices, perSlice),
                                              notes.unpacking);
                         whole.resize(pixelsOf(*slice.header));
                         unpackFrame(*slice.header, raw, whole.data(), notes.unpacking);
                         keepRows(whole, slice.header->columns, box, placeOf(array, index, slices, perSlice));
                       });
      },
      voxels.stored);
  return voxels;
}

DicomVoxels readModalityValues(const DicomSeries& series, const VoxelBox& box, const DicomKeeping& keeping,
                               const Progress& progress, DicomReadNotes& notes) {
  const std::size_t perSlice = areaOf(box), slices = slicesOf(box);
  auto values = kept<float>(keeping, perSlice * slices, notes.warnings);
  std::vector<double> stored(pixelsOf(*series.front().header));
  std::vector<float> whole(stored.size());
  forEachFrame(series, box, progress, [&](std::size_t index, const DicomSlice& slice, const auto& raw) {
    unpackFrame(*slice.header, raw, stored.data(), notes.unpacking);
    std::ranges::transform(stored, whole.begin(), [&](double value) { return modalityValue(slice, value); });
    keepRows(whole, slice.header->columns, box, placeOf(values, index, slices, perSlice));
  });
  const std::shared_ptr<Room> room = values.get_allocator().room();
  return {std::move(values), Rescale{}, std::nullopt, room, false};
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

template <class T>
struct Source {
  const RoomVector<T>& voxels;
  glm::ivec3 dims;
  std::optional<PaddingRange> padding;

  bool isValid(T stored) const {
    if constexpr (std::is_floating_point_v<T>)
      if (std::isnan(stored))
        return false;
    return !padding || stored < padding->first || stored > padding->last;
  }
};

/// The voxels of one slice that a sample mixes, along one axis: two neighbours and the weight of the second.
struct Neighbours {
  int first = 0;
  int second = 0;
  double weight = 0.0;
};

// A voxel owns its full extent: a slice covers [-0.5, count - 0.5), clamped beyond the outermost centres.
std::optional<Neighbours> neighbours(double position, int count) {
  if (!(position >= -0.5) || !(position < count - 0.5))
    return std::nullopt;
  const double clamped = std::clamp(position, 0.0, static_cast<double>(count - 1));
  const int first = static_cast<int>(clamped);
  return Neighbours{first, std::min(first + 1, count - 1), clamped - first};
}

/// What a slice holds at a sample: nothing, padding (not finite), or a value.
using Sample = std::optional<double>;

template <class T>
Sample sampleSlice(const Source<T>& source, int slice, const std::optional<Neighbours>& x,
                   const std::optional<Neighbours>& y) {
  if (!x || !y)
    return std::nullopt;
  const auto at = [&](int i, int j) { return source.voxels[voxelOffset(source.dims, i, j, slice)]; };
  const T corners[4] = {at(x->first, y->first), at(x->second, y->first), at(x->first, y->second),
                        at(x->second, y->second)};
  const double weights[4] = {(1.0 - x->weight) * (1.0 - y->weight), x->weight * (1.0 - y->weight),
                             (1.0 - x->weight) * y->weight, x->weight * y->weight};
  double mixed = 0.0;
  bool areValid = true;
  for (int c = 0; c < 4; ++c) {
    if (weights[c] == 0.0)
      continue;
    areValid = areValid && source.isValid(corners[c]);
    mixed += weights[c] * static_cast<double>(corners[c]);
  }
  if (areValid)
    return mixed;
  const T nearest = corners[std::max_element(weights, weights + 4) - weights];
  return source.isValid(nearest) ? Sample(static_cast<double>(nearest)) : std::nullopt;
}

/// The slices below and above a plane, and the weight of the upper.
Neighbours slicesAround(const std::vector<DicomPlacement>& placements, double heightMm) {
  const auto above = std::upper_bound(placements.begin(), placements.end(), heightMm,
                                      [](double h, const DicomPlacement& p) { return h < p.heightMm; });
  const int last = static_cast<int>(placements.size()) - 1;
  const int lower = std::clamp(static_cast<int>(above - placements.begin()) - 1, 0, last);
  const int upper = std::min(lower + 1, last);
  const double gap = placements[static_cast<std::size_t>(upper)].heightMm -
                     placements[static_cast<std::size_t>(lower)].heightMm;
  const double rise = heightMm - placements[static_cast<std::size_t>(lower)].heightMm;
  return {lower, upper, gap > 0.0 ? std::clamp(rise / gap, 0.0, 1.0) : 0.0};
}

Sample mixed(const Sample& lower, const Sample& upper, double weight) {
  if (weight == 0.0 || weight == 1.0 || !lower || !upper)
    return weight < 0.5 ? lower : upper;
  return *lower + weight * (*upper - *lower);
}

template <class T>
T storedOf(const Sample& sample, T empty) {
  if (!sample)
    return empty;
  if constexpr (std::is_floating_point_v<T>)
    return static_cast<T>(*sample);
  else
    return static_cast<T>(std::lround(*sample));
}

std::vector<std::optional<Neighbours>> columnOf(int outputCount, double shift, int sourceCount) {
  std::vector<std::optional<Neighbours>> result;
  result.reserve(static_cast<std::size_t>(outputCount));
  for (int i = 0; i < outputCount; ++i)
    result.push_back(neighbours(i - shift, sourceCount));
  return result;
}

template <class T>
void resamplePlane(const Source<T>& source, const DicomGeometry& geometry, int plane, T empty, T* out) {
  const glm::ivec3 dims = geometry.grid.dims;
  // Heights that differ from a slice's by rounding only must not mix in its neighbour.
  Neighbours slices = slicesAround(geometry.placements, plane * geometry.grid.spacingMm.z);
  if (slices.weight < 1e-6 || slices.weight > 1.0 - 1e-6)
    slices.weight = std::round(slices.weight);
  const glm::dvec2 lowerShift = geometry.placements[static_cast<std::size_t>(slices.first)].shift;
  const glm::dvec2 upperShift = geometry.placements[static_cast<std::size_t>(slices.second)].shift;
  const auto lowerX = columnOf(dims.x, lowerShift.x, source.dims.x);
  const auto lowerY = columnOf(dims.y, lowerShift.y, source.dims.y);
  const auto upperX = columnOf(dims.x, upperShift.x, source.dims.x);
  const auto upperY = columnOf(dims.y, upperShift.y, source.dims.y);
  for (std::size_t j = 0; j < lowerY.size(); ++j)
    for (std::size_t i = 0; i < lowerX.size(); ++i) {
      Sample lower, upper;
      if (slices.weight < 1.0)
        lower = sampleSlice(source, slices.first, lowerX[i], lowerY[j]);
      if (slices.weight > 0.0)
        upper = sampleSlice(source, slices.second, upperX[i], upperY[j]);
      *out++ = storedOf(mixed(lower, upper, slices.weight), empty);
    }
}

// Finds a value for voxels without data; nothing where the type has none left.
template <class T>
std::optional<T> emptyValue(const RoomVector<T>& voxels, const std::optional<PaddingRange>& padding) {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>)
    return Limits::quiet_NaN();
  if (padding && padding->first >= Limits::lowest() && padding->first <= Limits::max())
    return static_cast<T>(padding->first);
  const auto [lowest, highest] = std::minmax_element(voxels.begin(), voxels.end());
  if (*lowest > Limits::lowest())
    return Limits::lowest();
  if (*highest < Limits::max())
    return Limits::max();
  return std::nullopt;
}

// The same values in a wider type.
template <class T>
VoxelVectors widened(RoomVector<T> voxels) {
  const auto room = voxels.get_allocator().room();
  if constexpr (sizeof(T) == 1)
    return RoomVector<std::int16_t>(voxels.begin(), voxels.end(), room);
  else if constexpr (sizeof(T) == 2)
    return RoomVector<std::int32_t>(voxels.begin(), voxels.end(), room);
  else
    return RoomVector<double>(voxels.begin(), voxels.end(), room);
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
  const VoxelBox all{glm::ivec3(0), glm::ivec3(first.columns, first.rows, static_cast<int>(series.size()))};
  const VoxelBox box = keeping.box.value_or(all);
  DicomReadNotes notes{{}, warnings};
  noteFormat(series, warnings);
  DicomVoxels voxels = keepsStoredValues(series) ? readStored(series, box, keeping, progress, notes)
                                                 : readModalityValues(series, box, keeping, progress, notes);
  voxels.bitsIgnored = notes.unpacking.ignoredBits;
  return voxels;
}

DicomVoxels resampled(DicomVoxels voxels, const glm::ivec3& sourceDims, const DicomGeometry& geometry,
                      const DicomKeeping& keeping, const Progress& progress, std::vector<Message>& warnings) {
  return std::visit(
      [&]<class T>(RoomVector<T>& stored) -> DicomVoxels {
        const std::optional<T> empty = emptyValue(stored, voxels.padding);
        if (!empty)
          return resampled({widened(std::exchange(stored, {})), voxels.rescale, std::nullopt, voxels.room,
                            voxels.bitsIgnored},
                           sourceDims, geometry, keeping, progress, warnings);
        const Source<T> source{stored, sourceDims, voxels.padding};
        const glm::ivec3 dims = geometry.grid.dims;
        const std::size_t perPlane = static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y);
        const std::size_t count = perPlane * static_cast<std::size_t>(dims.z);
        const auto room =
            roomFor(keeping.path, static_cast<double>(count) * sizeof(T), keeping.budget, warnings);
        RoomVector<T> result(count, room);
        for (int plane = 0; plane < dims.z; ++plane) {
          reportOrStop(progress, static_cast<double>(plane) / dims.z, Message::tr("Straightening slices"));
          resamplePlane(source, geometry, plane, *empty,
                        result.data() + perPlane * static_cast<std::size_t>(plane));
        }
        std::optional<PaddingRange> padding = voxels.padding;
        if (!padding && !std::is_floating_point_v<T>)
          padding = PaddingRange{static_cast<double>(*empty), static_cast<double>(*empty)};
        return {std::move(result), voxels.rescale, padding, room, voxels.bitsIgnored};
      },
      voxels.stored);
}

} // namespace limn
