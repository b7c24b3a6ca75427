// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/Cutting.h"

#include "regions/Flood.h"
#include "regions/ScissorSet.h"
#include "regions/ValueSet.h"
#include "scene/basics/Error.h"
#include "scene/volume/NearestVoxel.h"

#include <algorithm>
#include <map>
#include <string>

namespace limn {
namespace {

// No file has them: segmentations number from 0.
constexpr int cutValue = -1, firstPieceValue = -3; // of pieces downwards
const Label besideLabel{-2, "Beside the piece", glm::dvec3(0.5)};

// The voxels whose place among the labels is marked.
BitGrid voxelsOf(const LabelMap& map, const std::vector<bool>& marked, const std::shared_ptr<Room>& room,
                 const Effort& effort) {
  const glm::ivec3& dims = map.dims();
  BitGrid set(dims, room);
  const std::vector<std::uint8_t> isMarked(marked.begin(), marked.end());
  std::visit(
      [&](const auto& places) {
        forEachPiece(dims.z, effort, [&](int z) {
          for (int y = 0; y < dims.y; ++y) {
            BitGrid::Word* row = set.row(y, z);
            const auto* stored = &places[voxelOffset(dims, 0, y, z)];
            for (int x = 0; x < dims.x; ++x)
              row[x / BitGrid::wordBits] |= BitGrid::Word{isMarked[stored[x]]} << x % BitGrid::wordBits;
          }
        });
      },
      map.places());
  return set;
}

// The labels before the cuts, or one for everything where there are none.
std::vector<Label> labelsBefore(const Region& region) {
  return region.labels ? region.labels->labels() : std::vector<Label>{{0, "Everything", glm::dvec3(0.8)}};
}

template <class Place>
std::shared_ptr<const LabelMap> relabelled(const Region& before, const BitGrid& set,
                                           const std::vector<Label>& labels,
                                           const std::shared_ptr<Room>& room, const Effort& effort) {
  const glm::ivec3& dims = set.dims();
  const auto last = static_cast<Place>(labels.size() - 1);
  RoomVector<Place> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z, room);
  // Most words of a row are all in the set, or all out of it.
  const auto fill = [&](const auto& copy) {
    forEachPiece(dims.z, effort, [&](int z) {
      for (int y = 0; y < dims.y; ++y)
        for (int w = 0; w < set.rowWords(); ++w) {
          const BitGrid::Word word = set.row(y, z)[w];
          const int x = w * BitGrid::wordBits, count = std::min(BitGrid::wordBits, dims.x - x);
          const std::size_t first = voxelOffset(dims, x, y, z);
          Place* out = &places[first];
          copy(first, count, out);
          if (word == set.voxelsOfWord(w))
            std::fill_n(out, count, last);
          else if (word != 0)
            for (int n = 0; n < count; ++n)
              out[n] = (word >> n & 1) != 0 ? last : out[n];
        }
    });
  };
  if (before.labels)
    std::visit(
        [&](const auto& stored) {
          fill([&stored](std::size_t from, int count, Place* out) {
            std::transform(&stored[from], &stored[from] + count, out,
                           [](auto place) { return static_cast<Place>(place); });
          });
        },
        before.labels->places());
  else
    fill([](std::size_t, int count, Place* out) { std::fill_n(out, count, Place{0}); });
  return std::make_shared<const LabelMap>(dims, std::move(places), labels);
}

// The region with the voxels of a set as one label more, the last, of this weight.
void addLabel(Region& region, const BitGrid& set, const Label& label, double weight,
              const std::shared_ptr<Room>& room, const Effort& effort) {
  std::vector<Label> labels = labelsBefore(region);
  labels.push_back(label);
  if (labels.size() > 65536)
    throw Error(Error::Kind::input, Message::tr("The segmentation has %1 labels, which leaves no number for "
                                                "what is cut away; cut without it.")
                                        .arg(labels.size() - 1));
  const bool fitsBytes = labels.size() <= 256 && !(region.labels && region.labels->places().index() == 1);
  if (!region.labels)
    region.weights = {1.0};
  region.labels = fitsBytes ? relabelled<std::uint8_t>(region, set, labels, room, effort)
                            : relabelled<std::uint16_t>(region, set, labels, room, effort);
  region.weights.push_back(weight);
}

std::vector<bool> shownLabels(const Region& before) {
  std::vector<bool> shown;
  for (const double weight : before.weights)
    shown.push_back(weight > 0.0);
  return shown;
}

// Of those the ones that have a look.
std::vector<bool> shownOfLook(const Region& region, std::size_t look) {
  std::vector<bool> shown = shownLabels(region);
  for (std::size_t place = 0; place < shown.size(); ++place)
    shown[place] = shown[place] && lookOfLabel(region, place) == look;
  return shown;
}

bool isPiece(const Cut& cut) {
  return cut.isOn && std::holds_alternative<ConnectedPiece>(cut.how);
}

bool hasPiece(const std::vector<Cut>& cuts) {
  return std::any_of(cuts.begin(), cuts.end(), isPiece);
}

// How many of the cuts the region's own labels show already, at their beginning: all of its own, or none.
std::size_t madeAlready(const Region& region, const std::vector<Cut>& cuts) {
  const bool goesOn = region.isCut && !needsCutting(region) && region.cuts.size() <= cuts.size() &&
                      std::equal(region.cuts.begin(), region.cuts.end(), cuts.begin());
  return goesOn ? region.cuts.size() : 0;
}

// What cuts take of the voxels: those that go, and those of each piece that has a look, in order.
struct CutSets {
  BitGrid removed;
  std::vector<BitGrid> pieces;
};

// What the labels of a region show of its cuts already; nothing where `isMade` is false.
CutSets cutSetsOf(const Region& region, bool isMade, const Volume& volume, const Effort& effort) {
  CutSets sets{BitGrid(volume.grid().dims, volume.room()), {}};
  if (!isMade)
    return sets;
  const auto voxelsOfLabel = [&](std::size_t place) {
    std::vector<bool> marked(region.weights.size());
    marked[place] = true;
    return voxelsOf(*region.labels, marked, volume.room(), effort);
  };
  for (std::size_t n = 0; n < region.cuts.size(); ++n)
    if (const std::optional<std::size_t> place = labelOfCut(region, n))
      sets.pieces.push_back(voxelsOfLabel(*place));
  if (isCutAway(region))
    sets.removed = voxelsOfLabel(region.weights.size() - 1);
  return sets;
}

// How much of what a piece hangs on was kept before: the weight of the label at its seed.
double weightAtSeed(const Region& before, const ConnectedPiece& piece, const Grid& grid) {
  const std::optional<glm::ivec3> voxel = nearestVoxel(worldToIndex(grid, piece.seedMm), grid.dims);
  if (!before.labels || !voxel)
    return 1.0;
  return before.weights[before.labels->placeAt(voxelOffset(grid.dims, voxel->x, voxel->y, voxel->z))];
}

// The region with the sets as labels more, and the pieces' looks.
void addCutLabels(Region& region, const Region& before, CutSets sets, const Volume& volume,
                  const Effort& effort) {
  std::map<std::size_t, TransferFunction> looks;
  for (std::size_t place = 0; place < before.weights.size(); ++place)
    if (const std::size_t look = lookOfLabel(before, place); look > 0)
      looks.emplace(place, before.looks[look - 1]);
  std::size_t n = 0;
  for (const Cut& cut : region.cuts)
    if (const ConnectedPiece* piece = pieceWithLook(cut)) {
      const int value = firstPieceValue - static_cast<int>(n);
      BitGrid set = sets.pieces[n++];
      set -= sets.removed;
      addLabel(region, set, {value, "Piece " + std::to_string(n), glm::dvec3(0.8)},
               weightAtSeed(before, *piece, volume.grid()), volume.room(), effort);
      looks.emplace(region.weights.size() - 1, piece->look);
    }
  if (std::any_of(region.cuts.begin(), region.cuts.end(), takesAway))
    addLabel(region, sets.removed, {cutValue, "Cut away", glm::dvec3(0.5)}, 0.0, volume.room(), effort);
  region = withLooks(region, looks);
}

BitGrid removedBy(const Cut& cut, const BitGrid& kept, const Volume& volume, const Effort& effort) {
  if (const auto* scissors = std::get_if<Scissors>(&cut.how))
    return takenBy(*scissors, volume.grid(), volume.room(), effort);
  const auto& piece = std::get<ConnectedPiece>(cut.how);
  const BitGrid found = pieceAmong(kept, volume, piece, effort);
  // Where nothing was hit, nothing goes: "only this" of nothing would empty the picture.
  return piece.fate == ConnectedPiece::Fate::alone && found.count() > 0 ? found.complement() : found;
}

} // namespace

bool needsCutting(const Region& region) {
  const bool isAny =
      std::any_of(region.cuts.begin(), region.cuts.end(), [](const Cut& cut) { return cut.isOn; });
  if (isAny != region.isCut)
    return true;
  return isAny && hasPiece(region.cuts) && shownLabels(withoutCuts(region)) != region.shownWhenCut;
}

std::vector<Cut> cutsMoved(std::vector<Cut> cuts, const Grid& from, const Grid& to) {
  const glm::dmat3 turn = to.direction * glm::transpose(from.direction);
  const bool isMirror = glm::determinant(turn) < 0.0;
  const auto moved = [&](const glm::dvec3& mm) { return indexToWorld(to, worldToIndex(from, mm)); };
  for (Cut& cut : cuts) {
    if (auto* piece = std::get_if<ConnectedPiece>(&cut.how)) {
      piece->seedMm = moved(piece->seedMm);
      continue;
    }
    auto& scissors = std::get<Scissors>(cut.how);
    scissors.camera.position = moved(scissors.camera.position);
    scissors.camera.target = moved(scissors.camera.target);
    scissors.camera.up = turn * scissors.camera.up;
    for (glm::dvec2& corner : scissors.polygon)
      corner.x = isMirror ? -corner.x : corner.x;
  }
  return cuts;
}

BitGrid keptVoxels(const Region& region, const Volume& volume, const Effort& effort) {
  if (!region.labels)
    return BitGrid(volume.grid().dims, volume.room()).complement();
  return voxelsOf(*region.labels, shownLabels(region), volume.room(), effort);
}

// The voxels whose centres lie within a distance of a place.
static BitGrid sphereAbout(const glm::dvec3& placeMm, double radiusMm, const Grid& grid, BitGrid empty) {
  const glm::dvec3 middle = worldToIndex(grid, placeMm);
  const glm::dvec3 radius = radiusMm / grid.spacingMm;
  const glm::ivec3 first = glm::max(glm::ivec3(glm::ceil(middle - radius)), glm::ivec3(0));
  const glm::ivec3 last = glm::min(glm::ivec3(glm::floor(middle + radius)), grid.dims - 1);
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x)
        if (glm::length((glm::dvec3(x, y, z) - middle) * grid.spacingMm) <= radiusMm)
          empty.set({x, y, z});
  return empty;
}

BitGrid pieceAmong(const BitGrid& kept, const Volume& volume, const ConnectedPiece& piece,
                   const Effort& effort) {
  const Grid& grid = volume.grid();
  BitGrid seed = kept.emptyLike();
  const std::optional<glm::ivec3> nearest = nearestVoxel(worldToIndex(grid, piece.seedMm), grid.dims);
  const BitGrid inRange = valuesWithin(volume, piece.range, partOf(effort, 0.0, 0.3));
  BitGrid allowed = inRange;
  allowed &= kept;
  if (piece.reachMm)
    allowed &= sphereAbout(piece.seedMm, *piece.reachMm, grid, kept.emptyLike());
  if (!nearest || !allowed.at(*nearest))
    return seed;
  seed.set(*nearest);
  BitGrid found = grownWithin(seed, allowed, partOf(effort, 0.3, 0.8));
  if (piece.growVoxels <= 0)
    return found;
  BitGrid grown = dilated(found, glm::dvec3(piece.growVoxels), partOf(effort, 0.8, 1.0));
  grown -= inRange;
  grown |= found;
  grown &= kept;
  return grown;
}

CutRegion cutRegion(const Volume& volume, const Region& region, std::vector<Cut> cuts, const Effort& effort) {
  const Region before = withoutCuts(region);
  CutRegion result{before, std::vector<std::size_t>(cuts.size())};
  const std::size_t made = madeAlready(region, cuts);
  const bool isAny = std::any_of(cuts.begin(), cuts.end(), [](const Cut& cut) { return cut.isOn; });
  result.region.cuts = cuts;
  if (!isAny) {
    result.left = keptVoxels(before, volume, effort).count();
    return result;
  }
  CutSets sets = cutSetsOf(region, made > 0, volume, partOf(effort, 0.0, 0.05));
  BitGrid kept = keptVoxels(before, volume, partOf(effort, 0.05, 0.1));
  kept -= sets.removed;
  result.left = kept.count();
  for (std::size_t n = made; n < cuts.size(); ++n) {
    if (!cuts[n].isOn)
      continue;
    const double from = 0.1 + 0.8 * static_cast<double>(n - made) / static_cast<double>(cuts.size() - made);
    const double to = 0.1 + 0.8 * static_cast<double>(n + 1 - made) / static_cast<double>(cuts.size() - made);
    if (const ConnectedPiece* piece = pieceWithLook(cuts[n])) {
      sets.pieces.push_back(pieceAmong(kept, volume, *piece, partOf(effort, from, to)));
      result.taken[n] = sets.pieces.back().count();
      continue;
    }
    sets.removed |= removedBy(cuts[n], kept, volume, partOf(effort, from, to));
    kept -= sets.removed;
    const std::size_t left = kept.count();
    result.taken[n] = result.left - left;
    result.left = left;
  }
  result.region.uncut = before.labels;
  addCutLabels(result.region, before, std::move(sets), volume, partOf(effort, 0.9, 1.0));
  result.region.isCut = true;
  if (hasPiece(cuts))
    result.region.shownWhenCut = shownLabels(before);
  return result;
}

Region lit(const Region& region, const BitGrid& lit, double weight, const Effort& effort) {
  Region shown = region;
  if (shown.labels) {
    // What is hidden already stays hidden; what fades keeps its look, so that each look fades by itself.
    const std::size_t looks = shown.looks.size();
    for (std::size_t look = 0; look <= looks; ++look) {
      const double from = static_cast<double>(look) / static_cast<double>(looks + 1);
      const double to = static_cast<double>(look + 1) / static_cast<double>(looks + 1);
      BitGrid beside = voxelsOf(*region.labels, shownOfLook(region, look), {},
                                partOf(effort, from, glm::mix(from, to, 0.3)));
      beside -= lit;
      addLabel(shown, beside, besideLabel, weight, {}, partOf(effort, glm::mix(from, to, 0.3), to));
      if (looks > 0) {
        shown.lookOf.resize(shown.weights.size());
        shown.lookOf.back() = static_cast<std::uint8_t>(look);
      }
    }
  } else {
    addLabel(shown, lit.complement(), besideLabel, weight, {}, effort);
  }
  return shown;
}

std::vector<Cut> cutsOver(const std::vector<Cut>& now, const std::vector<Cut>& then,
                          const std::vector<Cut>& wanted) {
  const auto [end, added] = std::ranges::mismatch(then, wanted);
  if (end != then.end())
    return wanted;
  std::vector<Cut> cuts = now;
  cuts.insert(cuts.end(), added, wanted.end());
  return cuts;
}

std::vector<Cut> withoutNames(std::vector<Cut> cuts) {
  for (Cut& cut : cuts)
    cut.name.clear();
  return cuts;
}

} // namespace limn
