// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/KeptRegion.h"

#include "app/core/sources/NamedFiles.h"
#include "io/labels/MaskFolder.h"
#include "regions/Body.h"
#include "regions/Cutting.h"
#include "scene/presets/PresetFit.h"
#include "scene/regions/BodyAndLabels.h"
#include "scene/volume/Orientation.h"
#include "scene/volume/VolumePart.h"

#include <algorithm>

namespace limn {
namespace {

const Message findingBody = Message::tr("Looking for the body");

// What is connected is known of the whole alone, which is read for this where a part is held.
BodyFinding bodyIn(const Volume& volume, const Progress& progress) {
  const Effort effort = effortOf(progress, findingBody);
  return volume.part() ? findBody(*reread(volume, allVoxels(volume.grid())), effort)
                       : findBody(volume, effort);
}

// Of cut `number`, which takes nothing; empty where nobody need know. A line that leaves its inside leaves
// all that was meant: of one that was just drawn it is said, of those that are opened again it is not.
Message remarkOnNothing(const Cut& cut, std::size_t number, bool isJustMade) {
  const auto* scissors = std::get_if<Scissors>(&cut.how);
  if (!scissors)
    return Message::tr("Cut %1 finds no piece: nothing in its range of values is left at its place.")
        .arg(number);
  if (scissors->removesInside)
    return Message::tr("Cut %1 takes nothing away: its line goes around nothing that is left.").arg(number);
  if (isJustMade)
    return Message::tr("Cut %1 takes nothing away: its line goes around all that is left.").arg(number);
  return {};
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

FoundRegion withBodyOf(const Region& labels, const Volume& volume, const Region& known,
                       const Progress& progress) {
  FoundRegion found = known.kind == Region::Kind::body ? FoundRegion{known, {}} : bodyOf(volume, progress);
  found.region = found.region.kind == Region::Kind::body
                     ? withBody(labels, found.region, volume.room(), effortOf(progress, findingBody))
                     : labels;
  return found;
}

Segmentation readBeside(const std::vector<std::filesystem::path>& files, const Volume& volume,
                        const Progress& progress) {
  return readSegmentations(files, gridOfFile(volume), progress, volume.info().patient);
}

FoundRegion openedBeside(const Region& kept, const Segmentation& opened, const Volume& volume,
                         const Progress& progress) {
  const Region before = withoutCuts(kept);
  if (!isOfMasks(before) || !isOfMasks(opened.region))
    return {opened.region, opened.remark, false, opened.covered, opened.smallestLast};
  const Segmentation joined =
      joinedMasks(before, opened.region, gridOfFile(volume), progress, volume.info().patient, volume.room());
  return {joined.region, opened.remark.followedBy(" ", joined.remark), false,
          opened.covered.followedBy(" ", joined.covered)};
}

bool replacesLabels(const Region& region, const Region& before) {
  const std::vector<std::string> sources = sourcesOf(region);
  return before.kind == Region::Kind::labels &&
         std::ranges::any_of(sourcesOf(before), [&](const std::string& source) {
           return std::ranges::find(sources, source) == sources.end();
         });
}

FoundRegion regionOf(const KeptPart& part, const Volume& volume, const Progress& progress) {
  FoundRegion found;
  if (part.kind == Region::Kind::body)
    found = bodyOf(volume, progress);
  if (part.kind == Region::Kind::labels) {
    std::vector<std::filesystem::path> paths{part.labels};
    paths.insert(paths.end(), part.moreLabels.begin(), part.moreLabels.end());
    Segmentation labels = readBeside(paths, volume, progress);
    found = {std::move(labels.region), labels.remark};
    const std::string name = std::filesystem::path(part.labels).filename().string();
    found.region.weights = weightsOf(found.region.labels->labels(), part.weights, name);
    found.region = withLooksOf(found.region, part.looks, name);
    if (part.hidesTable) {
      const FoundRegion beside = withBodyOf(found.region, volume, {}, progress);
      found = {beside.region, found.remark.empty() ? beside.remark : found.remark};
    }
  }
  return part.cuts.empty() ? found : cutIn(volume, found, part.cuts, progress);
}

namespace {

FoundRegion cutAnew(const Volume& volume, const Region& region, const std::vector<Cut>& cuts,
                    bool isLastJustMade, const Progress& progress) {
  const Effort effort = effortOf(progress, Message::tr("Cutting"));
  const bool needsAll = volume.part() && std::any_of(cuts.begin(), cuts.end(), [](const Cut& cut) {
                          return std::holds_alternative<ConnectedPiece>(cut.how);
                        });
  CutRegion made = needsAll ? cutRegion(*reread(volume, allVoxels(volume.grid())), region, cuts, effort)
                            : cutRegion(volume, region, cuts, effort);
  FoundRegion found{std::move(made.region), {}};
  // Of what stood there before it was said then.
  const auto known = static_cast<std::size_t>(std::ranges::mismatch(cuts, region.cuts).in1 - cuts.begin());
  for (std::size_t n = known; n < cuts.size() && found.remark.empty(); ++n)
    if (cuts[n].isOn && made.taken[n] == 0)
      found.remark = remarkOnNothing(cuts[n], n + 1, isLastJustMade && n + 1 == cuts.size());
  found.takesNothing = !found.remark.empty() && made.taken.back() == 0;
  if (made.left == 0)
    found.remark = Message::tr("The cuts take everything away.");
  return found;
}

} // namespace

FoundRegion cutIn(const Volume& volume, const Region& region, const std::vector<Cut>& cuts,
                  const Progress& progress) {
  return cutAnew(volume, region, cuts, true, progress);
}

FoundRegion cutIn(const Volume& volume, const FoundRegion& found, const std::vector<Cut>& cuts,
                  const Progress& progress) {
  FoundRegion cut = cutAnew(volume, found.region, cuts, false, progress);
  cut.covered = found.covered;
  cut.smallestLast = found.smallestLast;
  if (!found.remark.empty())
    cut.remark = found.remark;
  return cut;
}

// Which of a part's files of labels cannot be shown with the volume; the first where none is to blame alone.
static std::size_t misfitOf(const KeptPart& part, const Volume& volume, const Progress& progress) {
  for (std::size_t more = 0; more < part.moreLabels.size(); ++more)
    try {
      readBeside({part.moreLabels[more]}, volume, progress);
    } catch (const Error&) {
      return more + 1;
    }
  return 0;
}

FoundRegion regionOf(const KeptPart& part, const KeptPart& written, const Volume& volume,
                     const Progress& progress) {
  try {
    return regionOf(part, volume, progress);
  } catch (const Error& error) {
    if (part.kind != Region::Kind::labels || error.kind() != Error::Kind::input)
      throw;
    const std::size_t misfit = misfitOf(part, volume, progress);
    throw LabelsMissing(misfit == 0 ? written.labels : written.moreLabels[misfit - 1], error.sentence());
  }
}

} // namespace limn
