// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/LabelLooks.h"

#include "scene/ProjectionFacts.h"
#include "scene/volume/VolumePart.h"

#include <algorithm>
#include <map>

namespace limn {
namespace {

// What a label shows, and not only what it is said to.
bool counts(const Region& region, std::size_t place) {
  return region.weights[place] > 0.0 && !isEmpty(region.labels->boxAround(place));
}

const TransferFunction& functionOf(const Scene& scene, std::size_t place) {
  const std::size_t look = lookOfLabel(scene.keep, place);
  return look == 0 ? scene.transferFunction : scene.keep.looks[look - 1];
}

// The place of a function among others, behind which it is put where it is new.
std::uint8_t placeOf(std::vector<TransferFunction>& functions, const TransferFunction& function) {
  const auto known = std::find(functions.begin(), functions.end(), function);
  const auto place = static_cast<std::uint8_t>(known - functions.begin());
  if (known == functions.end())
    functions.push_back(function);
  return place;
}

// Where a function takes more than one value.
bool hasStepAt(const TransferFunction& function, double value) {
  return std::count_if(function.points.begin(), function.points.end(),
                       [value](const ControlPoint& point) { return point.value == value; }) > 1;
}

// The line of a function before its first point above, at a value.
ControlPoint pointIn(const TransferFunction& function, std::size_t segment, double value) {
  const std::vector<ControlPoint>& points = function.points;
  if (points.empty())
    return {value, glm::dvec3(0.0), 0.0};
  const ControlPoint& below = points[segment > 0 ? segment - 1 : 0];
  const ControlPoint& above = points[std::min(segment, points.size() - 1)];
  const double width = above.value - below.value;
  const double share = width > 0.0 ? std::clamp((value - below.value) / width, 0.0, 1.0) : 0.0;
  return {value, glm::mix(below.color, above.color, share), glm::mix(below.opacity, above.opacity, share)};
}

} // namespace

LabelLooks labelLooks(const Scene& scene) {
  const Region& region = scene.keep;
  LabelLooks looks{{scene.transferFunction}, {}};
  if (region.looks.empty() || !region.labels || !integrates(scene.projection))
    return looks;
  bool isOwnShown = false;
  looks.ofLabel.resize(region.weights.size());
  for (std::size_t place = 0; place < region.weights.size(); ++place) {
    if (!counts(region, place))
      continue;
    looks.ofLabel[place] = placeOf(looks.functions, functionOf(scene, place));
    isOwnShown = isOwnShown || looks.ofLabel[place] == 0;
  }
  if (!looks.areAny())
    return {{scene.transferFunction}, {}};
  // What weighs nothing has a share of its look all the same, of one that nothing shows an empty one.
  const TransferFunction nothing{scene.transferFunction.unitDistanceMm, {}};
  for (std::size_t place = 0; place < region.weights.size(); ++place) {
    if (counts(region, place) || lookOfLabel(region, place) == 0)
      continue;
    const TransferFunction& function = functionOf(scene, place);
    const bool isShown =
        std::find(looks.functions.begin(), looks.functions.end(), function) != looks.functions.end();
    looks.ofLabel[place] = placeOf(looks.functions, isShown ? function : nothing);
  }
  if (!isOwnShown)
    looks.functions.front().points.clear();
  return looks;
}

Region withLookOf(const Region& region, std::size_t place, const std::optional<TransferFunction>& look) {
  std::map<std::size_t, TransferFunction> looks;
  for (std::size_t label = 0; label < region.lookOf.size(); ++label)
    if (const std::size_t own = lookOfLabel(region, label); own > 0)
      looks.emplace(label, region.looks[own - 1]);
  looks.erase(place);
  if (look)
    looks.emplace(place, *look);
  Region changed = withLooks(region, looks);
  for (std::size_t n = 0; look && n < changed.cuts.size(); ++n)
    if (labelOfCut(region, n) == place)
      std::get<ConnectedPiece>(changed.cuts[n].how).look = normalised(*look);
  return changed;
}

TransferFunction inOneColor(TransferFunction function, const glm::dvec3& color) {
  for (ControlPoint& point : function.points)
    point.color = color;
  return function;
}

bool hasLabelLooks(const Scene& scene) {
  return labelLooks(scene).areAny();
}

const TransferFunction& functionAt(const LabelLooks& looks, const Region& region, std::size_t voxel) {
  return looks.functions[looks.areAny() ? looks.ofLabel[region.labels->placeAt(voxel)] : 0];
}

LookShares lookSharesAt(const LabelLooks& looks, const Region& region, const glm::dvec3& index) {
  const LabelMap& map = *region.labels;
  const glm::ivec3& dims = map.dims();
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(dims - 1));
  const glm::ivec3 low = glm::min(glm::ivec3(p), glm::max(dims - 2, 0));
  const glm::dvec3 within = p - glm::dvec3(low);
  LookShares shares;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 parts = glm::mix(1.0 - within, within, glm::bvec3(side));
    const double share = parts.x * parts.y * parts.z;
    if (!(share > 0.0))
      continue;
    const glm::ivec3 at = glm::min(low + side, dims - 1);
    const std::size_t place = map.placeAt(voxelOffset(dims, at.x, at.y, at.z));
    const std::size_t look = looks.ofLabel[place];
    LookShare* const end = shares.all.data() + shares.count;
    LookShare* const one =
        std::find_if(shares.all.data(), end, [look](const LookShare& known) { return known.look == look; });
    if (one == end) {
      *one = {look, 0.0, 0.0};
      ++shares.count;
    }
    one->share += share;
    one->weight += share * region.weights[place];
  }
  for (std::size_t i = 0; i < shares.count; ++i)
    shares.all[i].weight /= shares.all[i].share;
  return shares;
}

std::optional<std::size_t> lookOfCell(const LabelLooks& looks, const Region& region,
                                      const glm::dvec3& index) {
  const LabelMap& map = *region.labels;
  const glm::ivec3 last = map.dims() - 1;
  const glm::ivec3 low(glm::clamp(index, glm::dvec3(0.0), glm::dvec3(last)));
  std::optional<std::size_t> look;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 at = glm::min(low + glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2), last);
    const std::size_t own = looks.ofLabel[map.placeAt(voxelOffset(map.dims(), at.x, at.y, at.z))];
    if (look && *look != own)
      return std::nullopt;
    look = own;
  }
  return look;
}

LookSegments lookSegments(const std::vector<TransferFunction>& functions) {
  LookSegments all;
  for (const TransferFunction& function : functions)
    for (const ControlPoint& point : function.points)
      all.values.push_back(point.value);
  std::sort(all.values.begin(), all.values.end());
  all.values.erase(std::unique(all.values.begin(), all.values.end()), all.values.end());
  all.segments.assign(all.values.size() + 1, std::vector<std::size_t>(functions.size(), 0));
  for (std::size_t gap = 1; gap < all.segments.size(); ++gap)
    for (std::size_t i = 0; i < functions.size(); ++i) {
      const std::vector<ControlPoint>& points = functions[i].points;
      const auto above =
          std::upper_bound(points.begin(), points.end(), all.values[gap - 1],
                           [](double v, const ControlPoint& point) { return v < point.value; });
      all.segments[gap][i] = static_cast<std::size_t>(above - points.begin());
    }
  return all;
}

std::vector<TransferFunction> withCommonPoints(const std::vector<TransferFunction>& functions) {
  const LookSegments all = lookSegments(functions);
  std::vector<TransferFunction> common(functions.size());
  for (std::size_t f = 0; f < functions.size(); ++f)
    common[f].unitDistanceMm = functions[f].unitDistanceMm;
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    const bool isStep =
        std::any_of(functions.begin(), functions.end(),
                    [&](const TransferFunction& function) { return hasStepAt(function, all.values[i]); });
    for (std::size_t f = 0; f < functions.size(); ++f) {
      if (isStep)
        common[f].points.push_back(pointIn(functions[f], all.segments[i][f], all.values[i]));
      common[f].points.push_back(pointIn(functions[f], all.segments[i + 1][f], all.values[i]));
    }
  }
  return common;
}

TransferFunction unionOf(const std::vector<TransferFunction>& functions) {
  const std::vector<TransferFunction> common = withCommonPoints(functions);
  TransferFunction one = common.front();
  for (const TransferFunction& function : common)
    for (std::size_t i = 0; i < one.points.size(); ++i)
      one.points[i].opacity = std::max(one.points[i].opacity, function.points[i].opacity);
  return one;
}

} // namespace limn
