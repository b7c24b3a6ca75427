// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/regions/Cut.h"
#include "scene/volume/Grid.h"
#include "scene/volume/Volume.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace limn {

/// What is known of the voxels that share a label.
struct Label {
  int value = 0; ///< as the file has it; 0 is the background
  std::string name;
  glm::dvec3 color{1.0};
  std::string type{};     ///< what it is, among others of its file ("Rib"); empty: not told
  std::string category{}; ///< of which sort that is ("Anatomical Structure"); empty: not told
  bool operator==(const Label&) const = default;
};

/// One label for each voxel of a volume, on the volume's own grid; immutable. Voxels hold places in the list
/// of labels, x fastest.
class LabelMap {
public:
  using Places = std::variant<StoredVoxels<std::uint8_t>, StoredVoxels<std::uint16_t>>;

  /// Throws Error (input) where `places` has not as many entries as the grid voxels, where one lies beyond
  /// the list, or where the list is empty or longer than 65536.
  LabelMap(const glm::ivec3& dims, Places places, std::vector<Label> labels);

  const glm::ivec3& dims() const { return m_dims; }
  const Places& places() const { return m_places; }
  const std::vector<Label>& labels() const { return m_labels; }

  /// The place in the list of labels of a voxel, by its position in the stored array (voxelOffset).
  std::size_t placeAt(std::size_t voxel) const;

  /// The smallest box around the voxels of a place in the list; empty where there are none.
  const VoxelBox& boxAround(std::size_t place) const { return m_boxes[place]; }

private:
  glm::ivec3 m_dims;
  Places m_places;
  std::vector<Label> m_labels;
  std::vector<VoxelBox> m_boxes; // of each label
};

/// So many different looks of their own may the labels of a region have.
inline constexpr std::size_t mostLooks = 32;

/// Which part of a volume is kept (DEFINITION section 10): one weight for each label, which becomes one more
/// factor of the opacity. What was cut by hand (regions/Cutting.h) are labels more, behind its own: each
/// piece that has a look, in order, and then what was cut away.
struct Region {
  enum class Kind { all, body, labels };
  Kind kind = Kind::all;
  std::string source; ///< of labels: the file that they were read from, the first of masks
  std::shared_ptr<const LabelMap> labels; ///< none where all is kept; of a body: 0 falls away, 1 is kept
  std::vector<double> weights;            ///< 0..1 of each of the labels

  std::vector<Cut> cuts{};                 ///< in order; `labels` holds what they take once they are made
  bool isCut = false;                      ///< whether it does; what is cut away weighs 0
  std::shared_ptr<const LabelMap> uncut{}; ///< where it is: the labels before, none where all was kept
  std::vector<bool> shownWhenCut{}; ///< which of them weighed more than nothing then; what pieces hang on

  std::vector<TransferFunction>
      looks{};                        ///< of their own that labels have, at most `mostLooks`, all different
  std::vector<std::uint8_t> lookOf{}; ///< of each label: 0 the scene's, n `looks[n - 1]`; behind its end: 0

  std::vector<std::string> moreSources{}; ///< of masks in several files: the others, in order
  bool isOfFile = false; ///< of labels: whether `source` was no folder and may hold a mask, as it was read

  bool operator==(const Region&) const = default;
};

/// All files that the labels of a region were read from, in order.
std::vector<std::string> sourcesOf(const Region& region);

/// Each of them gets another name. `named` tells it by the one before.
void nameSources(Region& region, const std::function<std::string(const std::string&)>& named);

/// The look of a label by its place in the list: 0 the scene's, n `looks[n - 1]`.
std::size_t lookOfLabel(const Region& region, std::size_t place);

/// The region whose labels have these looks: `looks` holds one for each label that has one, by its place in
/// the list of labels. Equal looks become one; none is left where `looks` is empty. Throws Error (input)
/// where more than `mostLooks` differ, where a place is none of the region's, and what `normalised` throws.
Region withLooks(const Region& region, const std::map<std::size_t, TransferFunction>& looks);

/// How many labels a region has without those of its cuts.
std::size_t ownLabels(const Region& region);

/// Whether the cuts that a region's labels show take anything away.
bool isCutAway(const Region& region);

/// The place among the region's labels of the piece to which the `n`-th of its cuts gives a look; nothing
/// where that does something else, is off, or is not made yet.
std::optional<std::size_t> labelOfCut(const Region& region, std::size_t n);

/// The same as if nothing had been cut.
Region withoutCuts(const Region& region);

/// Whether the region changes a picture: some label that voxels may have weighs less than 1.
bool isRestricting(const Region& region);

/// The region that keeps `places` 1 of two labels and drops those of 0. `places` has one for each voxel.
Region bodyRegion(const glm::ivec3& dims, StoredVoxels<std::uint8_t> places);

/// The weight at a continuous voxel index: trilinear between voxel centres, clamped to the edge beyond the
/// outermost centres. 1 where there are no labels.
double weightAt(const Region& region, const glm::dvec3& index);

/// The weights of all voxels, x fastest, as 16-bit shares of 1 (0..65535): what renderers read that keep 16
/// bits a voxel. `out` has room for the voxels from `first` on, `count` of them.
void sharesOf(const Region& region, std::size_t first, std::size_t count, std::uint16_t* out);

} // namespace limn
