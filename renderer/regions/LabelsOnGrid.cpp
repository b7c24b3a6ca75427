// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/LabelsOnGrid.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <span>

namespace limn {
namespace {

constexpr std::size_t mostLabels = 65536; // with the background
constexpr double largestValue = 2147483647.0;

// Values that lie this close together are looked up in a table.
constexpr double mostInTable = 1 << 20;

// The places of labels by their value.
class PlacesByValue {
public:
  explicit PlacesByValue(const std::vector<Label>& labels) {
    int highest = 0;
    for (const Label& label : labels) {
      m_lowest = std::min(m_lowest, label.value);
      highest = std::max(highest, label.value);
    }
    const double span = static_cast<double>(highest) - m_lowest + 1.0;
    if (span <= mostInTable)
      m_table.resize(static_cast<std::size_t>(span));
    for (std::size_t place = 0; place < labels.size(); ++place)
      if (m_table.empty())
        m_places[labels[place].value] = static_cast<std::uint16_t>(place);
      else
        m_table[static_cast<std::size_t>(labels[place].value - m_lowest)] = static_cast<std::uint16_t>(place);
  }

  std::uint16_t of(int value) const {
    return m_table.empty() ? m_places.at(value) : m_table[static_cast<std::size_t>(value - m_lowest)];
  }

private:
  int m_lowest = 0;
  std::vector<std::uint16_t> m_table;
  std::map<int, std::uint16_t> m_places; // where there is no table
};

// The label of each voxel of a label volume.
class Values {
public:
  explicit Values(const Volume& labels) : m_labels(labels) {}

  template <class T>
  int at(const StoredVoxels<T>& stored, std::size_t voxel) const {
    const VoxelMask& invalid = m_labels.invalidMask();
    if (!invalid.empty() && invalid[voxel])
      return 0;
    const Rescale& rescale = m_labels.rescale();
    const double value = rescale.slope * static_cast<double>(stored[voxel]) + rescale.intercept;
    const double whole = std::round(value);
    if (std::abs(value - whole) > 1e-6 || std::abs(whole) > largestValue)
      throw Error(Error::Kind::input, Message::tr("It is no label map: its values are no whole numbers; open "
                                                  "a segmentation, not the image that it was made of."));
    return static_cast<int>(whole);
  }

private:
  const Volume& m_labels;
};

// The values that occur, ascending behind 0, which always leads.
template <class T>
std::vector<int> valuesIn(const Volume& volume, const StoredVoxels<T>& stored) {
  const Values values(volume);
  const double lowest = std::floor(std::min(volume.range().lowest, 0.0));
  const double span = std::ceil(std::max(volume.range().highest, 0.0)) - lowest + 1.0;
  std::vector<bool> seen(span <= mostInTable ? static_cast<std::size_t>(span) : 0);
  std::set<int> found; // where there is no table
  int last = 0;
  for (std::size_t voxel = 0; voxel < stored.size(); ++voxel) {
    const int value = values.at(stored, voxel);
    if (value == last)
      continue;
    last = value;
    if (!seen.empty())
      seen[static_cast<std::size_t>(value - lowest)] = true;
    else if (found.insert(value).second && found.size() > mostLabels)
      break;
  }
  for (std::size_t n = 0; n < seen.size(); ++n)
    if (seen[n])
      found.insert(static_cast<int>(lowest) + static_cast<int>(n));
  found.erase(0);
  if (found.size() >= mostLabels)
    throw Error(Error::Kind::input,
                Message::tr("It is no label map: it has more than 65535 different values; open a "
                            "segmentation, not the image that it was made of."));
  std::vector<int> all{0};
  all.insert(all.end(), found.begin(), found.end());
  return all;
}

std::vector<Label> labelsFor(const std::vector<int>& values, const std::vector<Label>& described,
                             const std::string& alone) {
  std::map<int, Label> known;
  for (const Label& label : described)
    known.emplace(label.value, label);
  std::vector<Label> labels;
  for (const int value : values) {
    const auto found = known.find(value);
    Label label = found != known.end() ? found->second : Label{value, {}, labelColor(labels.size())};
    if (label.name.empty())
      label.name = value == 0                             ? "Background"
                   : values.size() == 2 && !alone.empty() ? alone
                                                          : "Label " + std::to_string(value);
    labels.push_back(std::move(label));
  }
  if (labels.front().name == "Background")
    labels.front().color = glm::dvec3(0.5);
  return labels;
}

// The index of a voxel of the label volume that is nearest to the centre of a voxel of another grid.
class NearestVoxel {
public:
  NearestVoxel(const Grid& from, const Grid& to)
      : m_dims(to.dims), m_origin(worldToIndex(to, indexToWorld(from, glm::dvec3(0.0)))) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = 1.0;
      m_steps[axis] = worldToIndex(to, indexToWorld(from, step)) - m_origin;
    }
    if (areAligned(from.dims))
      for (int axis = 0; axis < 3; ++axis)
        fillTable(axis, from.dims[axis]);
  }

  // Its position in the stored array; negative where it lies outside.
  std::ptrdiff_t at(int x, int y, int z) const {
    if (!m_tables[0].empty()) {
      const std::ptrdiff_t inX = m_tables[0][static_cast<std::size_t>(x)];
      const std::ptrdiff_t inY = m_tables[1][static_cast<std::size_t>(y)];
      const std::ptrdiff_t inZ = m_tables[2][static_cast<std::size_t>(z)];
      return inX < 0 || inY < 0 || inZ < 0 ? -1 : inX + inY + inZ;
    }
    const glm::ivec3 index(glm::floor(m_origin + m_steps * glm::dvec3(x, y, z) + 0.5 + tie));
    if (glm::any(glm::lessThan(index, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(index, m_dims)))
      return -1;
    return static_cast<std::ptrdiff_t>(voxelOffset(m_dims, index.x, index.y, index.z));
  }

private:
  // Centres that lie between two voxels up to rounding go to the same one everywhere.
  static constexpr double tie = 1e-7;

  // Whether the axes of both grids are the same in some order, so that each can be looked up by itself; what
  // rounding leaves beside an axis is less than a tie. Axes that two of the other grid's share are none.
  bool areAligned(const glm::ivec3& dims) const {
    glm::bvec3 isTaken(false);
    for (int axis = 0; axis < 3; ++axis)
      for (int other = 0; other < 3; ++other)
        if (std::abs(m_steps[axis][other]) * dims[axis] > tie / 2.0) {
          if (isTaken[other] || otherAxisOf(axis) != other)
            return false;
          isTaken[other] = true;
        }
    return glm::all(isTaken);
  }

  int otherAxisOf(int axis) const {
    const glm::dvec3 size = glm::abs(m_steps[axis]);
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  void fillTable(int axis, int count) {
    const int other = otherAxisOf(axis);
    const std::ptrdiff_t stride = other == 0   ? 1
                                  : other == 1 ? m_dims.x
                                               : static_cast<std::ptrdiff_t>(m_dims.x) * m_dims.y;
    for (int n = 0; n < count; ++n) {
      const double index = std::floor(m_origin[other] + n * m_steps[axis][other] + 0.5 + tie);
      m_tables[static_cast<std::size_t>(axis)].push_back(
          index >= 0.0 && index < m_dims[other] ? static_cast<std::ptrdiff_t>(index) * stride : -1);
    }
  }

  glm::ivec3 m_dims;
  glm::dvec3 m_origin;
  glm::dmat3 m_steps{1.0};
  std::array<std::vector<std::ptrdiff_t>, 3> m_tables; // of axes that are aligned; -1 lies outside
};

template <class Place, class T>
RoomVector<Place> placesOn(const Grid& grid, const Volume& volume, const StoredVoxels<T>& stored,
                           const std::vector<Label>& labels, const Effort& effort) {
  const Values values(volume);
  const NearestVoxel nearest(grid, volume.grid());
  const PlacesByValue placeOf(labels);
  const glm::ivec3& dims = grid.dims;
  RoomVector<Place> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 0, volume.room());
  forEachPiece(dims.z, effort, [&](int z) {
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        if (const std::ptrdiff_t voxel = nearest.at(x, y, z); voxel >= 0)
          places[voxelOffset(dims, x, y, z)] =
              static_cast<Place>(placeOf.of(values.at(stored, static_cast<std::size_t>(voxel))));
  });
  return places;
}

// Gives the voxels of a mask a place in the list of labels; how many there were, by the place that they had.
template <class Place, class T>
std::vector<std::size_t> takenBy(std::span<Place> places, const Grid& grid, const Volume& mask,
                                 const StoredVoxels<T>& stored, std::size_t place, const Effort& effort) {
  const NearestVoxel nearest(grid, mask.grid());
  const VoxelMask& invalid = mask.invalidMask();
  const Rescale rescale = mask.rescale();
  const glm::ivec3& dims = grid.dims;
  std::vector<std::vector<std::size_t>> taken(static_cast<std::size_t>(dims.z));
  forEachPiece(dims.z, effort, [&](int z) {
    std::vector<std::size_t>& had = taken[static_cast<std::size_t>(z)];
    had.assign(place, 0);
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const std::ptrdiff_t at = nearest.at(x, y, z);
        if (at < 0)
          continue;
        const auto voxel = static_cast<std::size_t>(at);
        const bool isIn = rescale.slope * static_cast<double>(stored[voxel]) + rescale.intercept > 0.0 &&
                          (invalid.empty() || !invalid[voxel]);
        if (!isIn)
          continue;
        Place& own = places[voxelOffset(dims, x, y, z)];
        ++had[own];
        own = static_cast<Place>(place);
      }
  });
  std::vector<std::size_t> sums(place, 0);
  for (const std::vector<std::size_t>& had : taken)
    std::transform(had.begin(), had.end(), sums.begin(), sums.begin(), std::plus());
  return sums;
}

} // namespace

bool isMask(const Volume& volume) {
  const ValueRange& range = volume.range();
  if (range.lowest < 0.0 || (range.lowest > 0.0 && range.lowest < range.highest))
    return false;
  return visitVoxels(volume, [&](const auto& stored) {
    const VoxelMask& invalid = volume.invalidMask();
    const Rescale& rescale = volume.rescale();
    for (std::size_t voxel = 0; voxel < stored.size(); ++voxel) {
      const double value = rescale.slope * static_cast<double>(stored[voxel]) + rescale.intercept;
      if (value != 0.0 && value != range.highest && (invalid.empty() || !invalid[voxel]))
        return false;
    }
    return true;
  });
}

MasksOnGrid::MasksOnGrid(const Grid& grid, std::size_t most, std::shared_ptr<Room> room)
    : m_grid(grid), m_labels{{0, "Background", glm::dvec3(0.5)}} {
  const std::size_t voxels = static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z;
  if (most < 256)
    m_places = StoredVoxels<std::uint8_t>(RoomVector<std::uint8_t>(voxels, 0, std::move(room)));
  else
    m_places = StoredVoxels<std::uint16_t>(RoomVector<std::uint16_t>(voxels, 0, std::move(room)));
}

std::size_t MasksOnGrid::add(const Volume& mask, const Label& label, const Effort& effort) {
  const std::vector<std::size_t> taken = std::visit(
      [&](auto& places) {
        return visitVoxels(mask, [&](const auto& stored) {
          return takenBy(places.writable(), m_grid, mask, stored, m_labels.size(), effort);
        });
      },
      m_places);
  const std::size_t voxels = std::accumulate(taken.begin(), taken.end(), std::size_t{0});
  if (voxels == 0)
    return 0;
  m_labels.push_back(label);
  for (std::size_t place = 1; place < taken.size(); ++place)
    noteOverlap(place, m_labels.size() - 1, taken[place]);
  return voxels;
}

void MasksOnGrid::noteOverlap(std::size_t loser, std::size_t winner, std::size_t voxels) {
  m_overlapping += voxels;
  if (voxels > 0)
    m_takers[loser].push_back(winner);
  if (voxels > (m_largest ? m_largest->voxels : 0))
    m_largest = Overlap{m_labels[loser].name, m_labels[winner].name, voxels};
}

void MasksOnGrid::add(const LabelMap& masks, const std::vector<std::optional<Label>>& labels,
                      const Effort& effort) {
  std::vector<std::size_t> placeOf(labels.size(), 0);
  for (std::size_t n = 0; n < labels.size(); ++n)
    if (labels[n]) {
      placeOf[n] = m_labels.size();
      m_labels.push_back(*labels[n]);
    }
  const glm::ivec3& dims = m_grid.dims;
  std::vector<std::map<std::pair<std::size_t, std::size_t>, std::size_t>> overlaps(
      static_cast<std::size_t>(dims.z)); // of each slice
  std::visit(
      [&](auto& places, const auto& given) {
        const auto own = places.writable();
        using Place = typename std::remove_reference_t<decltype(own)>::value_type;
        forEachPiece(dims.z, effort, [&](int z) {
          const std::size_t first = voxelOffset(dims, 0, 0, z), end = voxelOffset(dims, 0, 0, z + 1);
          for (std::size_t n = first; n < end; ++n) {
            const std::size_t place = placeOf[given[n]];
            if (place == 0)
              continue;
            if (own[n] != 0)
              ++overlaps[static_cast<std::size_t>(z)][{own[n], place}];
            own[n] = static_cast<Place>(place);
          }
        });
      },
      m_places, masks.places());
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> sums;
  for (const auto& ofSlice : overlaps)
    for (const auto& [pair, voxels] : ofSlice)
      sums[pair] += voxels;
  for (const auto& [pair, voxels] : sums)
    noteOverlap(pair.first, pair.second, voxels);
}

std::vector<MasksOnGrid::Covered> MasksOnGrid::coveredIn(const LabelMap& finished) const {
  const std::vector<Label>& labels = finished.labels();
  std::vector<Covered> covered;
  for (const auto& [place, takers] : m_takers)
    if (const VoxelBox& box = finished.boxAround(place); box.lower == box.upper)
      covered.push_back(
          {labels[place].name, takers.size() == 1 ? labels[takers.front()].name : std::string()});
  return covered;
}

std::shared_ptr<const LabelMap> MasksOnGrid::finished() {
  return std::make_shared<const LabelMap>(m_grid.dims, std::move(m_places), std::move(m_labels));
}

glm::dvec3 labelColor(std::size_t n) {
  // Hues a golden section apart never come close to one another soon; three rows of brightness besides.
  const double hue = std::fmod(0.618033988749895 * static_cast<double>(n), 1.0) * 6.0;
  const double value = 1.0 - 0.2 * static_cast<double>(n / 3 % 3), chroma = 0.65 * value;
  glm::dvec3 color;
  for (int channel = 0; channel < 3; ++channel) {
    const double k = std::fmod(5.0 - 2.0 * channel + hue, 6.0);
    color[channel] = value - chroma * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  }
  return color;
}

std::shared_ptr<const LabelMap> labelsOnGrid(const Volume& labels, const std::vector<Label>& described,
                                             const Grid& grid, const Effort& effort,
                                             const std::string& alone) {
  return visitVoxels(labels, [&](const auto& stored) {
    std::vector<Label> found = labelsFor(valuesIn(labels, stored), described, alone);
    LabelMap::Places places;
    if (found.size() <= 256)
      places = placesOn<std::uint8_t>(grid, labels, stored, found, effort);
    else
      places = placesOn<std::uint16_t>(grid, labels, stored, found, effort);
    return std::make_shared<const LabelMap>(grid.dims, std::move(places), std::move(found));
  });
}

} // namespace limn
