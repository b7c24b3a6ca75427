// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/BodyAndLabels.h"

#include "scene/basics/Error.h"

#include <vector>

namespace limn {
namespace {

template <class Place>
RoomVector<Place> joined(const LabelMap& labels, const LabelMap& body, const std::shared_ptr<Room>& room,
                         const Effort& effort) {
  const glm::ivec3& dims = labels.dims();
  const auto table = static_cast<Place>(labels.labels().size());
  RoomVector<Place> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z, room);
  std::visit(
      [&](const auto& own, const auto& kept) {
        forEachPiece(dims.z, effort, [&](int z) {
          const std::size_t first = voxelOffset(dims, 0, 0, z), end = voxelOffset(dims, 0, 0, z + 1);
          for (std::size_t n = first; n < end; ++n)
            places[n] = kept[n] != 0 ? static_cast<Place>(own[n]) : table;
        });
      },
      labels.places(), body.places());
  return places;
}

} // namespace

Region withBody(const Region& labels, const Region& body, const std::shared_ptr<Room>& room,
                const Effort& effort) {
  const LabelMap& map = *labels.labels;
  std::vector<Label> listed = map.labels();
  listed.push_back({tableLabelValue, "Table and holder", glm::dvec3(0.5)});
  if (listed.size() > 65536)
    throw Error(Error::Kind::input, Message::tr("The segmentation has %1 labels, which leaves no number for "
                                                "what is not the body; switch Body only off.")
                                        .arg(map.labels().size()));
  Region both = labels;
  both.weights.push_back(0.0);
  both.labels = listed.size() <= 256
                    ? std::make_shared<const LabelMap>(
                          map.dims(), joined<std::uint8_t>(map, *body.labels, room, effort), listed)
                    : std::make_shared<const LabelMap>(
                          map.dims(), joined<std::uint16_t>(map, *body.labels, room, effort), listed);
  return both;
}

std::optional<std::size_t> tableLabel(const Region& region) {
  if (region.kind != Region::Kind::labels || !region.labels || ownLabels(region) == 0)
    return std::nullopt;
  const std::size_t last = ownLabels(region) - 1;
  return region.labels->labels()[last].value == tableLabelValue ? std::optional(last) : std::nullopt;
}

bool hidesTable(const Region& region) {
  const std::optional<std::size_t> table = tableLabel(region);
  return region.kind == Region::Kind::body || (table && region.weights[*table] < 1.0);
}

std::size_t listedLabels(const Region& region) {
  return tableLabel(region).value_or(ownLabels(region));
}

} // namespace limn
