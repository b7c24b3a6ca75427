// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/framing/VisibleBox.h"

#include "scene/ProjectionFacts.h"
#include "scene/basics/Error.h"
#include "scene/framing/KeptVoxels.h"
#include "scene/volume/VolumePart.h"

#include <algorithm>
#include <optional>
#include <type_traits>

namespace limn {
namespace {

// Which scalars show, given the weight that the region leaves their opacity.
class Shown {
public:
  explicit Shown(const Scene& scene)
      : m_function(scene.transferFunction), m_isComposite(scene.projection != Projection::isosurface) {
    if (showsSurface(scene.projection))
      m_isovalue = scene.isovalue;
  }

  bool at(double scalar, double weight) const {
    if (m_isovalue && scalar >= *m_isovalue && weight >= 0.5)
      return true;
    return m_isComposite && classify(m_function, scalar).opacity * weight >= visibleOpacity;
  }

  // Whether some scalar between two may.
  bool between(double lowest, double highest) const {
    return (m_isovalue && highest >= *m_isovalue) ||
           (m_isComposite && largestOpacityWithin(m_function, lowest, highest) >= visibleOpacity);
  }

private:
  const TransferFunction& m_function;
  bool m_isComposite;
  std::optional<double> m_isovalue;
};

// Whether stored voxels show. The values of small types are classified once.
template <class T>
class VoxelTest {
public:
  VoxelTest(const Scene& scene, const StoredVoxels<T>& stored)
      : m_stored(stored), m_rescale(scene.volume->rescale()), m_shown(scene),
        m_region(isRestricting(scene.keep) ? &scene.keep : nullptr) {
    if constexpr (sizeof(T) <= 2) {
      m_table.resize(std::size_t{1} << (8 * sizeof(T)));
      for (std::size_t place = 0; place < m_table.size(); ++place)
        m_table[place] = showsAt(static_cast<T>(place), 1.0);
    }
  }

  // False where none of `count` voxels from `first` on can show, found in one quick pass: most rows around a
  // body hold nothing but air.
  bool mayShow(std::size_t first, int count) const {
    const T* voxels = m_stored.data() + first;
    T lowest = voxels[0];
    T highest = voxels[0];
    for (int i = 1; i < count; ++i) {
      lowest = voxels[i] < lowest ? voxels[i] : lowest;
      highest = voxels[i] > highest ? voxels[i] : highest;
    }
    const double a = scalarOf(lowest);
    const double b = scalarOf(highest);
    return m_shown.between(std::min(a, b), std::max(a, b));
  }

  // `voxel` is the place in the array, `label` that among all voxels.
  bool shows(std::size_t voxel, std::size_t label) const {
    const T value = m_stored[voxel];
    if constexpr (sizeof(T) <= 2) {
      if (!m_table[static_cast<std::make_unsigned_t<T>>(value)])
        return false;
      if (!m_region)
        return true;
    }
    return showsAt(value, m_region ? m_region->weights[m_region->labels->placeAt(label)] : 1.0);
  }

private:
  double scalarOf(T value) const {
    return m_rescale.slope * static_cast<double>(value) + m_rescale.intercept;
  }

  bool showsAt(T value, double weight) const { return m_shown.at(scalarOf(value), weight); }

  const StoredVoxels<T>& m_stored;
  Rescale m_rescale;
  Shown m_shown;
  const Region* m_region;
  std::vector<std::uint8_t> m_table; // by the bits of the value
};

// Shrinks a box from all sides until something shows there: only what lies around it is looked at.
template <class T>
class Shrinking {
public:
  // `held` are the voxels of the array, `within` some of them, both in a volume of `dims`.
  Shrinking(const VoxelTest<T>& test, const glm::ivec3& dims, const VoxelBox& held, const VoxelBox& within,
            const Effort& effort)
      : m_test(test), m_dims(dims), m_held(held), m_box(within), m_effort(effort) {}

  std::optional<VoxelBox> box() {
    for (const int axis : {2, 1}) {
      const int lower = firstPlane(axis, 1);
      if (lower >= m_box.upper[axis])
        return std::nullopt;
      m_box.lower[axis] = lower;
      m_box.upper[axis] = firstPlane(axis, -1) + 1;
    }
    shrinkRows();
    return m_box;
  }

private:
  // The first plane across an axis in which something shows, from the end that `step` leads away from; the
  // upper end where there is none.
  int firstPlane(int axis, int step) const {
    const int from = step > 0 ? m_box.lower[axis] : m_box.upper[axis] - 1;
    const int count = m_box.upper[axis] - m_box.lower[axis];
    for (int i = 0; i < count; ++i)
      if (planeShows(axis, from + step * i))
        return from + step * i;
    return m_box.upper[axis];
  }

  bool planeShows(int axis, int plane) const {
    VoxelBox part = m_box;
    part.lower[axis] = plane;
    part.upper[axis] = plane + 1;
    for (int z = part.lower.z; z < part.upper.z; ++z) {
      requireNotCancelled();
      for (int y = part.lower.y; y < part.upper.y; ++y)
        if (firstShown(y, z, part.lower.x, part.upper.x) < part.upper.x)
          return true;
    }
    return false;
  }

  // Row by row, as the voxels lie in memory. Some row shows something.
  void shrinkRows() {
    int lower = m_box.upper.x;
    int upper = m_box.lower.x;
    for (int z = m_box.lower.z; z < m_box.upper.z; ++z) {
      requireNotCancelled();
      for (int y = m_box.lower.y; y < m_box.upper.y; ++y) {
        lower = firstShown(y, z, m_box.lower.x, lower);
        upper = behindLastShown(y, z, upper, m_box.upper.x);
      }
    }
    m_box.lower.x = lower;
    m_box.upper.x = upper;
  }

  int firstShown(int y, int z, int from, int to) const {
    std::size_t place = placeOf(from, y, z);
    std::size_t label = voxelOffset(m_dims, from, y, z);
    if (from < to && !m_test.mayShow(place, to - from))
      return to;
    while (from < to && !m_test.shows(place++, label++))
      ++from;
    return from;
  }

  int behindLastShown(int y, int z, int from, int to) const {
    if (from < to && !m_test.mayShow(placeOf(from, y, z), to - from))
      return from;
    std::size_t place = placeOf(to, y, z);
    std::size_t label = voxelOffset(m_dims, to, y, z);
    while (to > from && !m_test.shows(--place, --label))
      --to;
    return to;
  }

  std::size_t placeOf(int x, int y, int z) const {
    return voxelOffset(m_held.upper - m_held.lower, x - m_held.lower.x, y - m_held.lower.y,
                       z - m_held.lower.z);
  }

  void requireNotCancelled() const {
    if (m_effort.isCancelled && m_effort.isCancelled())
      throw Cancelled();
  }

  const VoxelTest<T>& m_test;
  glm::ivec3 m_dims;
  VoxelBox m_held;
  VoxelBox m_box;
  const Effort& m_effort;
};

} // namespace

IndexBox visibleBox(const Scene& scene, const Effort& effort) {
  const Grid& grid = scene.volume->grid();
  const IndexBox cropped = croppedBox(grid, scene.crop);
  const VolumePart* part = scene.volume->part().get();
  const std::optional<VoxelBox> found =
      part ? part->visible(scene) : visibleVoxels(scene, croppedVoxels(grid, scene.crop), effort);
  if (!found)
    return cropped;
  // A voxel owns half of the way to its neighbours; one more on each side.
  const glm::dvec3 centre = centreIndex(grid);
  return {glm::max(glm::dvec3(found->lower) - 1.5 - centre, cropped.lower),
          glm::min(glm::dvec3(found->upper) + 0.5 - centre, cropped.upper)};
}

std::optional<VoxelBox> visibleVoxels(const Scene& scene, const VoxelBox& within, const Effort& effort) {
  if (isEmpty(within))
    return std::nullopt;
  const Volume& volume = *scene.volume;
  const VoxelBox held = volume.part() ? volume.part()->box : allVoxels(volume.grid());
  const auto look = [&]<class T>(const StoredVoxels<T>& stored) {
    const VoxelTest<T> test(scene, stored);
    return Shrinking<T>(test, volume.grid().dims, held, within, effort).box();
  };
  return std::visit(look, volume.stored());
}

VisibleVoxels joined(const VisibleVoxels& a, const VisibleVoxels& b) {
  if (!a.box || !b.box)
    return a.box ? a : b;
  return {VoxelBox{glm::min(a.box->lower, b.box->lower), glm::max(a.box->upper, b.box->upper)}};
}

VoxelBox intersection(const VoxelBox& a, const VoxelBox& b) {
  const glm::ivec3 lower = glm::max(a.lower, b.lower);
  return {lower, glm::max(lower, glm::min(a.upper, b.upper))};
}

} // namespace limn
