// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/framing/VisibleVoxels.h"

#include "scene/LabelLooks.h"
#include "scene/ProjectionFacts.h"
#include "scene/framing/KeptVoxels.h"
#include "scene/framing/Outermost.h"
#include "scene/volume/VolumePart.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <optional>
#include <type_traits>

namespace limn {
namespace {

// So many units fill 42 MB where all are visible; framing on all of a box takes a few milliseconds.
constexpr std::int64_t mostUnits = std::int64_t{1} << 28;
constexpr std::int64_t mostUnitsOfABox = std::int64_t{1} << 24;
constexpr int mostUnitVoxels = 8; // a block's row of voxels fits a word

int unitVoxelsFor(const VoxelBox& box, std::int64_t most) {
  const glm::i64vec3 size(glm::max(box.upper - box.lower, 0));
  int unit = 1;
  while (unit < mostUnitVoxels && size.x * size.y * size.z / (unit * unit * unit) > most)
    ++unit;
  return unit;
}

// Which scalars show, given the weight that the region leaves their opacity, under one function.
class ShownByOne {
public:
  ShownByOne(const Scene& scene, const TransferFunction& function, double leastOpacity)
      : m_function(function), m_leastOpacity(leastOpacity),
        m_isComposite(scene.projection != Projection::isosurface) {
    if (showsSurface(scene.projection))
      m_isovalue = scene.isovalue;
  }

  bool at(double scalar, double weight) const {
    if (m_isovalue && scalar >= *m_isovalue && weight >= 0.5)
      return true;
    return m_isComposite && classify(m_function, scalar).opacity * weight >= m_leastOpacity;
  }

  // Whether those between two do, all or none; nothing where they may differ.
  std::optional<bool> between(double lowest, double highest) const {
    // What is interpolated between two opacities may lie beyond both by rounding.
    const double rounding = 1e-9 * m_leastOpacity;
    const bool mayReach = m_isovalue && highest >= *m_isovalue;
    if (!mayReach &&
        !(m_isComposite && largestOpacityWithin(m_function, lowest, highest) >= m_leastOpacity - rounding))
      return false;
    if ((m_isovalue && lowest >= *m_isovalue) ||
        (m_isComposite && leastOpacityWithin(lowest, highest) >= m_leastOpacity + rounding))
      return true;
    return std::nullopt;
  }

private:
  double leastOpacityWithin(double lowest, double highest) const {
    double least = std::min(classify(m_function, lowest).opacity, classify(m_function, highest).opacity);
    for (const ControlPoint& point : m_function.points)
      if (point.value >= lowest && point.value <= highest)
        least = std::min(least, point.opacity);
    return least;
  }

  TransferFunction m_function;
  double m_leastOpacity;
  bool m_isComposite;
  std::optional<double> m_isovalue;
};

// The same under the functions of several looks: whatever one of them shows, or one alone.
class Shown {
public:
  Shown(const Scene& scene, const LabelLooks& looks, double leastOpacity) {
    for (const TransferFunction& function : looks.functions)
      m_each.emplace_back(scene, function, leastOpacity);
  }

  bool at(double scalar, double weight) const {
    return std::any_of(m_each.begin(), m_each.end(),
                       [&](const ShownByOne& one) { return one.at(scalar, weight); });
  }

  bool at(double scalar, double weight, std::size_t look) const { return m_each[look].at(scalar, weight); }

  std::optional<bool> between(double lowest, double highest) const {
    bool mayShow = false;
    for (const ShownByOne& one : m_each) {
      const std::optional<bool> all = one.between(lowest, highest);
      if (all.value_or(false))
        return true;
      mayShow = mayShow || !all;
    }
    return mayShow ? std::nullopt : std::optional(false);
  }

private:
  std::vector<ShownByOne> m_each;
};

// Which stored voxels show. Values are looked up by their places in a list: of small types each value has
// one, of large types the scalars of a bin share one, and are classified where they may differ.
template <class T>
class VoxelTest {
public:
  VoxelTest(const Scene& scene, const StoredVoxels<T>& stored, double leastOpacity)
      : m_stored(stored), m_rescale(scene.volume->rescale()), m_looks(labelLooks(scene)),
        m_shown(scene, m_looks, leastOpacity),
        m_region(isRestricting(scene.keep) || m_looks.areAny() ? &scene.keep : nullptr),
        m_range(scene.volume->range()) {
    if (!isSmall && m_range.highest > m_range.lowest)
      m_perScalar = bins / (m_range.highest - m_range.lowest);
    const std::size_t places = isSmall ? std::size_t{1} << (8 * std::min<std::size_t>(sizeof(T), 2)) : bins;
    m_mayBefore.resize(places + 1);
    m_doBefore.resize(places + 1);
    for (std::size_t place = 0; place < places; ++place) {
      const std::optional<bool> all = shownAt(place);
      m_mayBefore[place + 1] = m_mayBefore[place] + (all.value_or(true) ? 1 : 0);
      m_doBefore[place + 1] = m_doBefore[place] + (all.value_or(false) ? 1 : 0);
    }
  }

  // One bit for each of `count` ≤ 64 voxels of a row, the first in the lowest bit. `voxel` is the place of
  // the first in the array, `label` that among all voxels.
  std::uint64_t bitsOf(std::size_t voxel, std::size_t label, int count) const {
    std::uint64_t bits = bitsWithoutRegion(m_stored.data() + voxel, count);
    if (m_region)
      for (std::uint64_t left = bits; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        const std::size_t place = m_region->labels->placeAt(label + i);
        const double weight = m_region->weights[place];
        const std::size_t look = m_looks.areAny() ? m_looks.ofLabel[place] : 0;
        if ((weight < 1.0 || m_looks.areAny()) &&
            !(weight > 0.0 && m_shown.at(scalarOf(m_stored[voxel + i]), weight, look)))
          bits &= ~(std::uint64_t{1} << i);
      }
    return bits;
  }

private:
  static constexpr bool isSmall = sizeof(T) <= 2;
  static constexpr int bins = 4096;

  // Most words of voxels lie in air or in the body, where all do the same, which the range of their values
  // tells.
  std::uint64_t bitsWithoutRegion(const T* voxels, int count) const {
    const auto [lowest, highest] = count == 64 ? rangeOf64(voxels) : rangeOf(voxels, count);
    const auto [from, to] = std::minmax({placeOf(lowest), placeOf(highest)});
    if (m_mayBefore[to + 1] == m_mayBefore[from])
      return 0;
    if (m_doBefore[to + 1] - m_doBefore[from] == to - from + 1)
      return ~std::uint64_t{0} >> (64 - count);
    std::uint64_t bits = 0;
    for (int i = 0; i < count; ++i) {
      const std::size_t place = placeOf(voxels[i]);
      std::uint64_t shows = m_doBefore[place + 1] - m_doBefore[place];
      if (!isSmall && shows == 0 && m_mayBefore[place + 1] != m_mayBefore[place])
        shows = showsAt(voxels[i], 1.0) ? 1 : 0;
      bits |= shows << i;
    }
    return bits;
  }

  static std::pair<T, T> rangeOf(const T* voxels, int count) {
    const auto [lowest, highest] = std::minmax_element(voxels, voxels + count);
    return {*lowest, *highest};
  }

  // Eight at a time, which compilers make of no more than one of floats on their own.
  static std::pair<T, T> rangeOf64(const T* voxels) {
    std::array<T, 8> lowest, highest;
    std::copy_n(voxels, 8, lowest.begin());
    highest = lowest;
    for (int i = 8; i < 64; i += 8)
      for (int lane = 0; lane < 8; ++lane) {
        const T value = voxels[i + lane];
        const auto at = static_cast<std::size_t>(lane);
        lowest[at] = value < lowest[at] ? value : lowest[at];
        highest[at] = value > highest[at] ? value : highest[at];
      }
    return {*std::ranges::min_element(lowest), *std::ranges::max_element(highest)};
  }

  std::size_t placeOf(T value) const {
    if constexpr (isSmall)
      return static_cast<std::size_t>(static_cast<std::int64_t>(value) - std::numeric_limits<T>::lowest());
    else
      return static_cast<std::size_t>(
          std::clamp((scalarOf(value) - m_range.lowest) * m_perScalar, 0.0, bins - 1.0));
  }

  // What all values of a place do; nothing where they may differ.
  std::optional<bool> shownAt(std::size_t place) const {
    if constexpr (isSmall)
      return showsAt(static_cast<T>(static_cast<std::int64_t>(place) + std::numeric_limits<T>::lowest()),
                     1.0);
    // Wider than the bin, by more than rounding puts values into a neighbour.
    const double from = (static_cast<double>(place) - 1e-3) / bins;
    const double to = (static_cast<double>(place) + 1.0 + 1e-3) / bins;
    return m_shown.between(glm::mix(m_range.lowest, m_range.highest, from),
                           glm::mix(m_range.lowest, m_range.highest, to));
  }

  double scalarOf(T value) const {
    return m_rescale.slope * static_cast<double>(value) + m_rescale.intercept;
  }

  bool showsAt(T value, double weight) const { return m_shown.at(scalarOf(value), weight); }

  const StoredVoxels<T>& m_stored;
  Rescale m_rescale;
  LabelLooks m_looks;
  Shown m_shown;
  const Region* m_region;
  ValueRange m_range;
  double m_perScalar = 0.0;
  std::vector<std::uint32_t> m_mayBefore; // places below each of which some values show
  std::vector<std::uint32_t> m_doBefore;  // all
};

VisibleVoxels none(int unitVoxels) {
  VisibleVoxels visible;
  visible.unitVoxels = unitVoxels;
  return visible;
}

VoxelBox boxOf(const VisibleVoxels& visible) {
  return {visible.lower, visible.upper};
}

void widen(VisibleVoxels& visible, const glm::ivec3& lower, const glm::ivec3& upper) {
  const bool isFirst = isEmpty(boxOf(visible));
  visible.lower = isFirst ? lower : glm::min(visible.lower, lower);
  visible.upper = isFirst ? upper : glm::max(visible.upper, upper);
}

// The blocks that lie in a row along x, made from rows of voxels.
class BlockRow {
public:
  // Of the blocks from `first` on, up to that before `end`, in units of `unit` voxels.
  BlockRow(const glm::ivec3& first, int end, int unit) : m_first(first), m_unit(unit) {
    m_blocks.resize(static_cast<std::size_t>(std::max(0, end - first.x)));
    for (std::size_t i = 0; i < m_blocks.size(); ++i)
      m_blocks[i].place = first + glm::ivec3(static_cast<int>(i), 0, 0);
    m_found = none(unit);
  }

  int firstVoxel() const { return m_first.x * blockUnits * m_unit; }
  std::size_t words() const {
    return (m_blocks.size() * blockUnits * static_cast<std::size_t>(m_unit) + 63) / 64;
  }

  // Bits of the voxels from firstVoxel on, of the row (y, z); `bits` is as long as `words`.
  void add(int y, int z, const std::vector<std::uint64_t>& bits) {
    const auto isSet = [](std::uint64_t word) { return word != 0; };
    const auto firstSet = std::ranges::find_if(bits, isSet);
    if (firstSet == bits.end())
      return;
    const auto lastSet = std::find_if(bits.rbegin(), bits.rend(), isSet);
    const int from = 64 * static_cast<int>(firstSet - bits.begin()) + std::countr_zero(*firstSet);
    const int to = 64 * static_cast<int>(bits.rend() - lastSet) - std::countl_zero(*lastSet);
    widen(m_found, {firstVoxel() + from, y, z}, {firstVoxel() + to, y + 1, z + 1});
    const int side = blockUnits * m_unit;
    const int bit = 8 * (y % side / m_unit);
    const auto word = static_cast<std::size_t>(z % side / m_unit);
    for (int i = from / side; i <= (to - 1) / side; ++i) {
      const auto place = static_cast<std::size_t>(i);
      const std::uint64_t voxels = voxelsFrom(bits, place * static_cast<std::size_t>(side), side);
      VisibleBlock& block = m_blocks[place];
      block.voxels += static_cast<std::uint32_t>(std::popcount(voxels));
      block.units[word] |= unitsOf(voxels) << bit;
    }
  }

  VisibleVoxels found() {
    for (const VisibleBlock& block : m_blocks)
      if (block.voxels > 0) {
        m_found.blocks.push_back(block);
        m_found.voxels += block.voxels;
      }
    return std::move(m_found);
  }

private:
  static std::uint64_t voxelsFrom(const std::vector<std::uint64_t>& bits, std::size_t from, int count) {
    const std::size_t word = from / 64;
    const std::size_t shift = from % 64;
    std::uint64_t voxels = bits[word] >> shift;
    if (shift + static_cast<std::size_t>(count) > 64 && word + 1 < bits.size())
      voxels |= bits[word + 1] << (64 - shift);
    return voxels & ~std::uint64_t{0} >> (64 - count);
  }

  std::uint64_t unitsOf(std::uint64_t voxels) const {
    if (m_unit == 1)
      return voxels;
    std::uint64_t units = 0;
    for (int i = 0; i < blockUnits; ++i, voxels >>= m_unit)
      if ((voxels & ~(~std::uint64_t{0} << m_unit)) != 0)
        units |= std::uint64_t{1} << i;
    return units;
  }

  glm::ivec3 m_first;
  int m_unit;
  std::vector<VisibleBlock> m_blocks;
  VisibleVoxels m_found;
};

// One behind the other: the blocks of each lie behind those of all before it.
VisibleVoxels chained(const std::vector<VisibleVoxels>& rows, int unitVoxels) {
  VisibleVoxels all = none(unitVoxels);
  std::size_t blocks = 0;
  for (const VisibleVoxels& row : rows)
    blocks += row.blocks.size();
  all.blocks.reserve(blocks);
  for (const VisibleVoxels& row : rows) {
    all.blocks.insert(all.blocks.end(), row.blocks.begin(), row.blocks.end());
    all.voxels += row.voxels;
    if (!row.blocks.empty())
      widen(all, row.lower, row.upper);
  }
  return all;
}

// What `rowBits(first, y, z, bits)` sets of the voxels within a box, in rows of blocks.
template <class RowBits>
VisibleVoxels gathered(const VoxelBox& box, int unit, const Effort& effort, const RowBits& rowBits) {
  const int side = blockUnits * unit;
  const glm::ivec3 first = box.lower / side;
  const glm::ivec3 blocks = (box.upper + side - 1) / side - first;
  std::vector<VisibleVoxels> rows(static_cast<std::size_t>(blocks.y) * blocks.z);
  forEachPiece(static_cast<int>(rows.size()), effort, [&](int piece) {
    const glm::ivec3 place = first + glm::ivec3(0, piece % blocks.y, piece / blocks.y);
    BlockRow row(place, first.x + blocks.x, unit);
    std::vector<std::uint64_t> bits(row.words());
    for (int z = std::max(box.lower.z, place.z * side); z < std::min(box.upper.z, (place.z + 1) * side); ++z)
      for (int y = std::max(box.lower.y, place.y * side); y < std::min(box.upper.y, (place.y + 1) * side);
           ++y) {
        std::ranges::fill(bits, 0);
        rowBits(row.firstVoxel(), y, z, bits);
        row.add(y, z, bits);
      }
    rows[static_cast<std::size_t>(piece)] = row.found();
  });
  return chained(rows, unit);
}

bool isBefore(const VisibleBlock& a, const VisibleBlock& b) {
  return std::tie(a.place.z, a.place.y, a.place.x) < std::tie(b.place.z, b.place.y, b.place.x);
}

// What is found by `look(box, unit)`: again in smaller units where little is visible of a large volume.
template <class Look>
VisibleVoxels foundBy(const VoxelBox& box, const Look& look) {
  const int unit = unitVoxelsFor(box);
  VisibleVoxels found = look(box, unit);
  if (const int finer = unitVoxelsFor(boxOf(found)); !found.blocks.empty() && finer < unit)
    found = look(boxOf(found), finer);
  return found;
}

// What is visible; none where nothing is.
VisibleVoxels visibleOrNone(const Scene& scene, const Effort& effort) {
  const VoxelBox left = croppedVoxels(scene.volume->grid(), scene.crop);
  if (const VolumePart* part = scene.volume->part().get())
    return foundBy(left, [&](const VoxelBox&, int unit) { return part->visible(scene, unit); });
  return foundBy(left,
                 [&](const VoxelBox& box, int unit) { return visibleWithin(scene, box, unit, effort); });
}

} // namespace

int unitVoxelsFor(const VoxelBox& box) {
  return unitVoxelsFor(box, mostUnits);
}

VisibleVoxels joined(const VisibleVoxels& a, const VisibleVoxels& b) {
  assert(a.unitVoxels == b.unitVoxels);
  if (a.blocks.empty() || b.blocks.empty())
    return b.blocks.empty() ? a : b;
  VisibleVoxels both = a;
  widen(both, b.lower, b.upper);
  both.voxels += b.voxels;
  both.blocks.clear();
  std::ranges::merge(a.blocks, b.blocks, std::back_inserter(both.blocks), isBefore);
  // Parts may share blocks, but no voxels.
  std::size_t last = 0;
  for (std::size_t i = 1; i < both.blocks.size(); ++i)
    if (const VisibleBlock& block = both.blocks[i]; block.place == both.blocks[last].place) {
      both.blocks[last].voxels += block.voxels;
      for (std::size_t word = 0; word < block.units.size(); ++word)
        both.blocks[last].units[word] |= block.units[word];
    } else {
      both.blocks[++last] = block;
    }
  both.blocks.resize(last + 1);
  return both;
}

VisibleVoxels visibleWithin(const Scene& scene, const VoxelBox& box, int unitVoxels, const Effort& effort,
                            double leastOpacity) {
  if (isEmpty(box))
    return none(unitVoxels);
  const Volume& volume = *scene.volume;
  const glm::ivec3 dims = volume.grid().dims;
  const VoxelBox held = volume.part() ? volume.part()->box : allVoxels(volume.grid());
  const auto look = [&]<class T>(const StoredVoxels<T>& stored) {
    const VoxelTest<T> test(scene, stored, leastOpacity);
    return gathered(box, unitVoxels, effort, [&](int first, int y, int z, std::vector<std::uint64_t>& bits) {
      const glm::ivec3 inHeld(-held.lower.x, y - held.lower.y, z - held.lower.z);
      for (int word = 0; word < static_cast<int>(bits.size()); ++word) {
        const int from = std::max(first + 64 * word, box.lower.x);
        const int count = std::min(first + 64 * (word + 1), box.upper.x) - from;
        if (count > 0)
          bits[static_cast<std::size_t>(word)] =
              test.bitsOf(voxelOffset(held.upper - held.lower, from + inHeld.x, inHeld.y, inHeld.z),
                          voxelOffset(dims, from, y, z), count)
              << (from - first - 64 * word);
      }
    });
  };
  return std::visit(look, volume.stored());
}

VisibleVoxels allVoxelsOf(const Grid& grid, const CropBox& crop) {
  VoxelBox box = croppedVoxels(grid, crop);
  const IndexBox cropped = croppedBox(grid, crop);
  const glm::dvec3 middle = 0.5 * (cropped.lower + cropped.upper) + centreIndex(grid);
  for (int axis = 0; axis < 3; ++axis)
    if (box.upper[axis] <= box.lower[axis]) {
      box.lower[axis] = std::clamp(static_cast<int>(std::lround(middle[axis])), 0, grid.dims[axis] - 1);
      box.upper[axis] = box.lower[axis] + 1;
    }
  return withoutInner(gathered(box, unitVoxelsFor(box, mostUnitsOfABox), {},
                               [&](int first, int, int, std::vector<std::uint64_t>& bits) {
                                 for (int word = 0; word < static_cast<int>(bits.size()); ++word) {
                                   const int from = std::clamp(box.lower.x - first - 64 * word, 0, 64);
                                   const int to = std::clamp(box.upper.x - first - 64 * word, 0, 64);
                                   if (from < to)
                                     bits[static_cast<std::size_t>(word)] =
                                         ~std::uint64_t{0} >> (64 - to + from) << from;
                                 }
                               }));
}

VisibleVoxels visibleVoxels(const Scene& scene, const Effort& effort) {
  VisibleVoxels found = visibleOrNone(scene, effort);
  return found.blocks.empty() ? allVoxelsOf(scene.volume->grid(), scene.crop)
                              : withoutInner(std::move(found));
}

IndexBox visibleBox(const Scene& scene, const Effort& effort) {
  const Grid& grid = scene.volume->grid();
  const IndexBox cropped = croppedBox(grid, scene.crop);
  const VisibleVoxels found = visibleOrNone(scene, effort);
  if (found.blocks.empty())
    return cropped;
  // A voxel owns half of the way to its neighbours; one more on each side.
  const glm::dvec3 centre = centreIndex(grid);
  return {glm::max(glm::dvec3(found.lower) - 1.5 - centre, cropped.lower),
          glm::min(glm::dvec3(found.upper) + 0.5 - centre, cropped.upper)};
}

namespace {

// A thousand unit distances of what is fainter add a quarter of one of 255 levels.
constexpr double faintestOpacity = 1e-6;

// Whether a scalar without opacity lies above one with: as the largest of a ray it hides what shows.
bool hidesAboveWhatShows(const TransferFunction& function) {
  bool shows = false;
  for (const ControlPoint& point : function.points) {
    if (shows && !(point.opacity > 0.0))
      return true;
    shows = point.opacity > 0.0;
  }
  return false;
}

} // namespace

bool cropsOnlyUnseen(const Scene& scene, const Effort& effort) {
  const Grid& grid = scene.volume->grid();
  if (scene.projection == Projection::minip || scene.projection == Projection::average ||
      (scene.projection == Projection::mip && hidesAboveWhatShows(scene.transferFunction)) ||
      scene.volume->part())
    return false;
  Scene whole = scene;
  whole.crop = {};
  const VoxelBox left = croppedVoxels(grid, scene.crop);
  VoxelBox rest = allVoxels(grid);
  // Slab by slab off each face, so that no voxel is looked at twice.
  for (int axis = 0; axis < 3; ++axis) {
    const int lower = scene.crop.lower[axis] > 0.0 ? left.lower[axis] + 1 : 0;
    const int upper = scene.crop.upper[axis] < 1.0 ? left.upper[axis] - 1 : grid.dims[axis];
    VoxelBox below = rest, above = rest;
    rest.lower[axis] = below.upper[axis] = std::min(lower, rest.upper[axis]);
    rest.upper[axis] = above.lower[axis] = std::max(upper, rest.lower[axis]);
    for (const VoxelBox& slab : {below, above})
      if (visibleWithin(whole, slab, unitVoxelsFor(slab), effort, faintestOpacity).voxels > 0)
        return false;
  }
  return true;
}

VoxelBox intersection(const VoxelBox& a, const VoxelBox& b) {
  const glm::ivec3 lower = glm::max(a.lower, b.lower);
  return {lower, glm::max(lower, glm::min(a.upper, b.upper))};
}

} // namespace limn
