// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/KeptRegion.h"

#include "io/labels/LabelReader.h"
#include "regions/Body.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Orientation.h"
#include "scene/volume/VolumePart.h"

namespace limn {
namespace {

const Message findingBody = Message::tr("Looking for the body");

// What is connected is known of the whole alone, which is read for this where a part is held.
BodyFinding bodyIn(const Volume& volume, const Progress& progress) {
  const Effort effort = effortOf(progress, findingBody);
  return volume.part() ? findBody(*reread(volume, allVoxels(volume.grid())), effort)
                       : findBody(volume, effort);
}

} // namespace

FoundRegion bodyOf(const Volume& volume, const Progress& progress) {
  BodyFinding found = bodyIn(volume, progress);
  FoundRegion kept{std::move(found.region), {}};
  if (kept.region.kind == Region::Kind::all)
    kept.remark =
        Message::tr("No body was found in the volume (%1), so everything is kept.").arg(found.doubt);
  else if (!found.isSure && !found.isAlone)
    kept.remark =
        Message::tr("Body only may be wrong here: %1; compare with everything shown.").arg(found.doubt);
  return kept;
}

Region sureBodyOf(const Volume& volume, const Progress& progress) {
  if (!looksLikeHounsfield(volume))
    return {};
  BodyFinding found = bodyIn(volume, progress);
  return found.isSure ? std::move(found.region) : Region{};
}

FoundRegion regionOf(const KeptPart& part, const Volume& volume, const Progress& progress) {
  if (part.kind == Region::Kind::all)
    return {};
  if (part.kind == Region::Kind::body)
    return bodyOf(volume, progress);
  Region region = readLabels(part.labels, gridOfFile(volume), progress);
  region.weights = weightsOf(region.labels->labels(), part.weights,
                             std::filesystem::path(part.labels).filename().string());
  return {std::move(region), {}};
}

} // namespace limn
