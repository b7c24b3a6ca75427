// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/Region.h"

#include "scene/basics/Effort.h"
#include "scene/basics/Error.h"
#include "scene/regions/LabelRuns.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace limn {
namespace {

void enclose(VoxelBox& box, const glm::ivec3& lower, const glm::ivec3& upper) {
  const bool isFirst = box.lower == box.upper;
  box = isFirst ? VoxelBox{lower, upper} : VoxelBox{glm::min(box.lower, lower), glm::max(box.upper, upper)};
}

/// The smallest box around each label, run by run of each row.
template <class Place>
std::vector<VoxelBox> boxesAround(const StoredVoxels<Place>& places, const glm::ivec3& dims,
                                  std::size_t labels) {
  std::vector<VoxelBox> boxes(labels);
  std::mutex guard;
  shareOut(dims.z, {}, [&](Pieces& slices) {
    std::vector<VoxelBox> own(labels);
    for (int k = slices.next(); k >= 0; k = slices.next())
      for (int j = 0; j < dims.y; ++j) {
        const Place* row = places.data() + voxelOffset(dims, 0, j, k);
        for (int first = 0, end = 0; first < dims.x; first = end) {
          const Place place = row[first];
          if (place >= labels)
            throw Error(Error::Kind::input, Message::tr("A voxel's label is missing in the list of labels."));
          end = endOfRun(row, first, dims.x);
          enclose(own[place], {first, j, k}, {end, j + 1, k + 1});
        }
      }
    const std::lock_guard lock(guard);
    for (std::size_t n = 0; n < labels; ++n)
      if (own[n].lower != own[n].upper)
        enclose(boxes[n], own[n].lower, own[n].upper);
  });
  return boxes;
}

} // namespace

LabelMap::LabelMap(const glm::ivec3& dims, Places places, std::vector<Label> labels)
    : m_dims(dims), m_places(std::move(places)), m_labels(std::move(labels)) {
  if (m_labels.empty() || m_labels.size() > 65536)
    throw Error(Error::Kind::input,
                Message::tr("A label map has 1 to 65536 labels; this one has %1.").arg(m_labels.size()));
  const auto voxels = static_cast<std::size_t>(dims.x) * dims.y * dims.z;
  std::visit(
      [&](const auto& all) {
        if (all.size() != voxels)
          throw Error(Error::Kind::input,
                      Message::tr("A label map has one label for each voxel; this one has %1 for %2.")
                          .arg(all.size(), voxels));
        m_boxes = boxesAround(all, dims, m_labels.size());
      },
      m_places);
}

std::size_t LabelMap::placeAt(std::size_t voxel) const {
  return std::visit([voxel](const auto& all) -> std::size_t { return all[voxel]; }, m_places);
}

std::size_t lookOfLabel(const Region& region, std::size_t place) {
  return place < region.lookOf.size() ? region.lookOf[place] : 0;
}

Region withLooks(const Region& region, const std::map<std::size_t, TransferFunction>& looks) {
  Region changed = region;
  changed.looks.clear();
  changed.lookOf.clear();
  for (const auto& [place, look] : looks) {
    if (place >= region.weights.size())
      throw Error(Error::Kind::input,
                  Message::tr("A look is given to a label that the volume does not have."));
    const TransferFunction sorted = normalised(look);
    auto at = std::find(changed.looks.begin(), changed.looks.end(), sorted);
    if (at == changed.looks.end())
      at = changed.looks.insert(at, sorted);
    if (changed.looks.size() > mostLooks)
      throw Error(
          Error::Kind::input,
          Message::tr("The labels have more than %1 different looks, which is as many as can be drawn; "
                      "give some of them the same look.")
              .arg(mostLooks));
    changed.lookOf.resize(region.weights.size());
    changed.lookOf[place] = static_cast<std::uint8_t>(at - changed.looks.begin() + 1);
  }
  return changed;
}

std::vector<std::string> sourcesOf(const Region& region) {
  std::vector<std::string> sources;
  if (!region.source.empty())
    sources.push_back(region.source);
  sources.insert(sources.end(), region.moreSources.begin(), region.moreSources.end());
  return sources;
}

void nameSources(Region& region, const std::function<std::string(const std::string&)>& named) {
  if (!region.source.empty())
    region.source = named(region.source);
  std::ranges::transform(region.moreSources, region.moreSources.begin(), named);
}

bool takesAway(const Cut& cut) {
  return cut.isOn && !pieceWithLook(cut);
}

const ConnectedPiece* pieceWithLook(const Cut& cut) {
  const auto* piece = std::get_if<ConnectedPiece>(&cut.how);
  return cut.isOn && piece && piece->fate == ConnectedPiece::Fate::ownLook ? piece : nullptr;
}

std::size_t ownLabels(const Region& region) {
  if (!region.isCut)
    return region.weights.size();
  const auto pieces = std::count_if(region.cuts.begin(), region.cuts.end(), pieceWithLook);
  return region.weights.size() - static_cast<std::size_t>(pieces) - (isCutAway(region) ? 1 : 0);
}

bool isCutAway(const Region& region) {
  return region.isCut && std::any_of(region.cuts.begin(), region.cuts.end(), takesAway);
}

std::optional<std::size_t> labelOfCut(const Region& region, std::size_t n) {
  if (!region.isCut || !pieceWithLook(region.cuts[n]))
    return std::nullopt;
  const auto end = region.cuts.begin() + static_cast<std::ptrdiff_t>(n);
  return ownLabels(region) + static_cast<std::size_t>(std::count_if(region.cuts.begin(), end, pieceWithLook));
}

Region withoutCuts(const Region& region) {
  Region whole{region.kind, region.source, region.isCut ? region.uncut : region.labels, region.weights};
  whole.moreSources = region.moreSources;
  whole.isOfFile = region.isOfFile;
  if (region.isCut)
    whole.weights.resize(whole.labels ? ownLabels(region) : 0);
  if (!region.isCut) {
    whole.looks = region.looks;
    whole.lookOf = region.lookOf;
    return whole;
  }
  std::map<std::size_t, TransferFunction> looks; // without those that pieces alone have
  for (std::size_t place = 0; place < whole.weights.size(); ++place)
    if (const std::size_t look = lookOfLabel(region, place); look > 0)
      looks.emplace(place, region.looks[look - 1]);
  return withLooks(whole, looks);
}

bool isRestricting(const Region& region) {
  return region.labels && std::any_of(region.weights.begin(), region.weights.end(),
                                      [](double weight) { return weight != 1.0; });
}

Region bodyRegion(const glm::ivec3& dims, StoredVoxels<std::uint8_t> places) {
  const std::vector<Label> labels{{0, "Table and holder", glm::dvec3(0.5)}, {1, "Body", glm::dvec3(1.0)}};
  return {Region::Kind::body, {}, std::make_shared<const LabelMap>(dims, std::move(places), labels), {0, 1}};
}

double weightAt(const Region& region, const glm::dvec3& index) {
  if (!region.labels)
    return 1.0;
  const LabelMap& map = *region.labels;
  const glm::ivec3& dims = map.dims();
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(dims - 1));
  const glm::ivec3 low = glm::min(glm::ivec3(p), glm::max(dims - 2, 0));
  const glm::dvec3 share = p - glm::dvec3(low);
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 weight = glm::mix(1.0 - share, share, glm::bvec3(side));
    const glm::ivec3 at = glm::min(low + side, dims - 1);
    const std::size_t voxel = (static_cast<std::size_t>(at.z) * dims.y + at.y) * dims.x + at.x;
    sum += weight.x * weight.y * weight.z * region.weights[map.placeAt(voxel)];
  }
  return sum;
}

void sharesOf(const Region& region, std::size_t first, std::size_t count, std::uint16_t* out) {
  std::vector<std::uint16_t> shares(region.weights.size());
  std::transform(region.weights.begin(), region.weights.end(), shares.begin(),
                 [](double weight) { return static_cast<std::uint16_t>(std::lround(65535.0 * weight)); });
  std::visit(
      [&](const auto& places) {
        for (std::size_t i = 0; i < count; ++i)
          out[i] = shares[places[first + i]];
      },
      region.labels->places());
}

} // namespace limn
