// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Error.h"
#include "scene/basics/Message.h"
#include "scene/basics/Room.h"
#include "scene/volume/Grid.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace limn {

/// Voxels of one type, one behind the other: in memory, or in a file that is mapped. Copies share them;
/// nobody changes them but who owns them alone.
template <class T>
class StoredVoxels {
public:
  using value_type = T;

  StoredVoxels() = default;

  /// Takes the values.
  template <class Allocator>
  StoredVoxels(std::vector<T, Allocator> values) {
    auto owner = std::make_shared<std::vector<T, Allocator>>(std::move(values));
    m_voxels = *owner;
    m_writable = owner->data();
    m_owner = std::move(owner);
  }

  /// Voxels that `owner` keeps where they are; they are only read.
  StoredVoxels(std::span<const T> voxels, std::shared_ptr<const void> owner)
      : m_voxels(voxels), m_owner(std::move(owner)) {}

  std::size_t size() const { return m_voxels.size(); }
  const T* data() const { return m_voxels.data(); }
  const T& operator[](std::size_t voxel) const { return m_voxels[voxel]; }
  auto begin() const { return m_voxels.begin(); }
  auto end() const { return m_voxels.end(); }

  /// Where they may be changed: in their place, or in a copy that lies in `room` where others read them or
  /// they cannot be written.
  std::span<T> writable(const std::shared_ptr<Room>& room = {}) {
    if (!m_writable || m_owner.use_count() > 1)
      *this = StoredVoxels(RoomVector<T>(begin(), end(), room));
    return {m_writable, size()};
  }

  friend bool operator==(const StoredVoxels& a, const StoredVoxels& b) {
    return std::ranges::equal(a.m_voxels, b.m_voxels);
  }

private:
  std::span<const T> m_voxels;
  std::shared_ptr<const void> m_owner;
  T* m_writable = nullptr; // the first voxel, where it may be written
};

/// One `Of` for each type in which voxels are stored. 64-bit integers become double on reading.
template <template <class> class Of>
using OfStoredType = std::variant<Of<std::uint8_t>, Of<std::int8_t>, Of<std::uint16_t>, Of<std::int16_t>,
                                  Of<std::uint32_t>, Of<std::int32_t>, Of<float>, Of<double>>;

/// Stored voxels, x fastest, then y, then z.
using VoxelArray = OfStoredType<StoredVoxels>;

/// Voxels while they are read, in a room or in memory.
using VoxelVectors = OfStoredType<RoomVector>;

/// Takes what was read over, without copying it.
inline VoxelArray storedVoxels(VoxelVectors voxels) {
  return std::visit([](auto& values) -> VoxelArray { return std::move(values); }, voxels);
}

/// One flag per voxel, in the order of the voxels; without any where no voxel has it.
class VoxelMask {
public:
  VoxelMask() = default;
  /// Without any flag yet; they lie in `room`, or in memory where there is none.
  explicit VoxelMask(std::size_t voxels, const std::shared_ptr<Room>& room = {})
      : m_words((voxels + 63) / 64, std::uint64_t{0}, room) {}

  bool empty() const { return m_words.empty(); }
  bool operator[](std::size_t voxel) const { return (m_words[voxel / 64] >> (voxel % 64) & 1) != 0; }

  /// The flags of 64 voxels from `voxel` on, the first in the lowest bit; 0 beyond the last.
  std::uint64_t from(std::size_t voxel) const {
    const std::size_t word = voxel / 64;
    const std::size_t shift = voxel % 64;
    const std::uint64_t low = word < m_words.size() ? m_words[word] >> shift : 0;
    return shift == 0 || word + 1 >= m_words.size() ? low : low | m_words[word + 1] << (64 - shift);
  }

  /// The flags of the voxels 64·n … 64·n+63.
  std::uint64_t& word(std::size_t n) { return m_words[n]; }

private:
  RoomVector<std::uint64_t> m_words;
};

/// What a file says, or its name lets expect, of how a volume was taken: enough to choose a first look, and
/// nothing that could name anybody.
struct ScanHints {
  enum class BodyPart { unknown, head, chest, abdomen, other };
  enum class Weighting { unknown, t1, t2, pd };
  std::string modality; ///< DICOM code; empty where nothing tells
  BodyPart bodyPart = BodyPart::unknown;
  Weighting weighting = Weighting::unknown; ///< of MR
  bool isAngiography = false;               ///< vessels filled with contrast, or by flow
  bool operator==(const ScanHints&) const = default;
};

/// From words in a description or a file's name ("cta_brain", "T1 MPRAGE sag"); words that say nothing leave
/// the hints as they are.
ScanHints withHintsOf(ScanHints hints, std::string_view text);

/// The weighting of a spin echo by its times (ms), both > 0: short repetition T1; long repetition PD where
/// the echo is short, T2 where it is long.
ScanHints::Weighting weightingBy(double repetitionMs, double echoMs);

/// Scalar = slope · stored + intercept (HU for CT).
struct Rescale {
  double slope = 1.0;
  double intercept = 0.0;
  bool operator==(const Rescale&) const = default;
};

/// Stored values (before rescaling) that the file declares to be no data, both ends included.
struct PaddingRange {
  double first = 0.0;
  double last = 0.0;
};

/// A closed interval of scalar values.
struct ValueRange {
  double lowest = 0.0;
  double highest = 0.0;
  bool operator==(const ValueRange&) const = default;
};

/// How many valid voxels have each stored value, from the lowest to the highest.
struct StoredCounts {
  int first = 0; ///< the lowest
  std::vector<std::uint64_t> counts;
};

/// Who the volume shows. Lives in memory only: no file, log or picture may contain it.
struct PatientLabel {
  std::string name;
  std::string id;
  std::string studyDate;
};

/// What a file says about its volume beside the voxels.
struct VolumeInfo {
  std::string format;   ///< e.g. "DICOM", "NIfTI-1"
  std::string modality; ///< DICOM code ("CT", "MR", "PT"), empty where unknown
  std::string unit;     ///< "HU" for CT, empty where unknown
  ScanHints hints;      ///< what chooses a first look
  bool orientationKnown = true;
  std::string
      orientationByHand; ///< the axes' letters that a person gave (Orientation.h), empty: the file told
  std::optional<Grid> gridOfFile; ///< where a person gave them: what the file alone says
  bool spacingKnown = true;
  bool slants = false; ///< as its slices were taken, which were resampled: the first of `warnings` says so
  std::vector<Message> warnings; ///< one sentence each, without patient data
  PatientLabel patient;
};

struct VoxelFacts; // scene/volume/VolumePart.h
struct VolumePart;

/// A grid of scalars, immutable once made. Every voxel is finite: invalid ones were replaced by the smallest
/// valid value (DEFINITION section 1).
class Volume {
public:
  /// Takes the stored voxels and sanitises them: NaN, ±Inf and declared padding are replaced by the voxel
  /// of the smallest valid scalar, counted, and remembered. `room` is where arrays that grow with the voxels
  /// lie.
  /// Throws Error (input) where the array does not match `grid.dims`, where a dimension or spacing is not
  /// positive and finite, where no voxel is valid, or where a scalar lies beyond ±1e300; Cancelled.
  Volume(Grid grid, VoxelArray stored, Rescale rescale, std::optional<PaddingRange> padding, VolumeInfo info,
         const Effort& effort = {}, std::shared_ptr<Room> room = {});

  /// One of which `stored` is a part alone, the voxels of `part->box`, made valid likewise. `facts` are those
  /// of all voxels: what the volume tells of itself is the same whatever part is held. Throws as above.
  Volume(Grid grid, VoxelArray stored, Rescale rescale, VolumeInfo info, const VoxelFacts& facts,
         std::shared_ptr<const VolumePart> part, const Effort& effort = {}, std::shared_ptr<Room> room = {});

  const Grid& grid() const { return m_grid; }

  /// Null where all voxels are held, as a rule. Where they are not, voxels are found through this alone.
  const std::shared_ptr<const VolumePart>& part() const { return m_part; }

  /// What is held, as a volume of its own whose range is the whole's, in its place in the world; the volume
  /// itself where all is held.
  Volume held() const;

  const VoxelArray& stored() const { return *m_stored; }

  /// Whether both show the same voxels, wherever they lie.
  bool sharesVoxelsWith(const Volume& other) const { return m_stored == other.m_stored; }
  const Rescale& rescale() const { return m_rescale; }
  const VolumeInfo& info() const { return m_info; }

  /// The same voxels, shared, where they lie otherwise; `grid` has the same dimensions.
  Volume placed(const Grid& grid, VolumeInfo info) const;

  /// Other scalars within the same range at the same voxels, of which the same are valid: `stored` has one
  /// for each.
  Volume withScalars(VoxelArray stored, Rescale rescale) const;

  /// Smallest and largest scalar of the valid voxels.
  const ValueRange& range() const { return m_range; }

  std::size_t voxelCount() const;
  std::size_t invalidVoxels() const { return m_invalidVoxels; }

  /// Set where the file's value was invalid; empty where all are valid.
  const VoxelMask& invalidMask() const { return m_invalid; }

  /// Of voxels stored in 8 or 16 bits, counted by the pass that found their range; empty otherwise. Of all,
  /// like range and number of invalid ones, also where a part is held.
  const StoredCounts& storedCounts() const { return m_counts; }

  /// Where all that is made of this volume and grows with its voxels belongs; null: in memory.
  const std::shared_ptr<Room>& room() const { return m_room; }

  /// False once a file that the voxels lie in became shorter, or its disk failed: voxels may be zeros that
  /// were not, and nothing made of them is to be believed.
  bool isWhole() const { return !m_room || m_room->isWhole(); }

  /// The scalar of voxel (i, j, k). Slow (a type dispatch per call): for bulk work use visitVoxels.
  double value(const glm::ivec3& index) const;

private:
  Grid m_grid;
  std::shared_ptr<const VoxelArray> m_stored;
  Rescale m_rescale;
  VolumeInfo m_info;
  ValueRange m_range;
  std::size_t m_invalidVoxels = 0;
  VoxelMask m_invalid;
  StoredCounts m_counts;
  std::shared_ptr<Room> m_room;
  std::shared_ptr<const VolumePart> m_part;
};

/// Position of voxel (i, j, k) in the stored array.
inline std::size_t voxelOffset(const glm::ivec3& dims, int i, int j, int k) {
  return (static_cast<std::size_t>(k) * dims.y + j) * dims.x + i;
}

/// The name of the stored type as `limn info` prints it: "uint8", "int16", "float32", …
std::string voxelTypeName(const VoxelArray& stored);

/// Calls `function(const StoredVoxels<T>& stored)` with the array in its own type.
template <class Function>
decltype(auto) visitVoxels(const Volume& volume, Function&& function) {
  assert(!volume.part()); // its array does not fill its grid
  return std::visit(std::forward<Function>(function), volume.stored());
}

/// The scalar at a continuous voxel index: trilinear between voxel centres, clamped to the edge beyond the
/// outermost centres. Slow; for probes and tests.
double valueAt(const Volume& volume, const glm::dvec3& index);

/// Throws Error (input) where voxels were lost since the volume was read: its file became shorter, or a disk
/// failed. To be asked before what was made of it is shown or written, where its file is not known by name.
inline void requireWhole(const Volume& volume) {
  if (!volume.isWhole())
    throw Error(Error::Kind::input, Message::tr("The volume's file became shorter while it was read, or its "
                                                "disk failed; copy the file again and open it anew."));
}

} // namespace limn
