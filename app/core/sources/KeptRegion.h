// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/labels/LabelReader.h"
#include "io/reading/Progress.h"
#include "io/scenefile/KeptPart.h"
#include "scene/Scene.h"

#include <filesystem>
#include <vector>

namespace limn {

/// A region, and why it is not what was asked for: one sentence, empty where it is.
struct FoundRegion {
  Region region;
  Message remark;
  bool takesNothing = false; ///< the last of its cuts, as the remark says
  Message covered{};         ///< of labels that others left no voxel to; the remark has it, too
  std::vector<std::filesystem::path> smallestLast{}; ///< in which order their files would (Segmentation)
};

/// The body of a volume, asked for: everything where there is none. Throws Cancelled.
FoundRegion bodyOf(const Volume& volume, const Progress& progress = {});

/// The body of a CT volume, unasked: everything where it is not sure or there is nothing to hide.
Region sureBodyOf(const Volume& volume, const Progress& progress = {});

/// A segmentation with what is not the body hidden beside it (scene/regions/BodyAndLabels.h); as it is where
/// no body is found; remarks are bodyOf's. `known` is the body where it was found before. Throws Error
/// (input), Cancelled.
FoundRegion withBodyOf(const Region& labels, const Volume& volume, const Region& known,
                       const Progress& progress = {});

/// A region with other cuts in the place of its own (regions/Cutting.h), and which of those it did not have
/// takes nothing away. Throws Error (input), Cancelled.
FoundRegion cutIn(const Volume& volume, const Region& region, const std::vector<Cut>& cuts,
                  const Progress& progress = {});

/// The same of a region that was found first and cuts that were made before; the remark on how it was found
/// goes before one on the cuts.
FoundRegion cutIn(const Volume& volume, const FoundRegion& found, const std::vector<Cut>& cuts,
                  const Progress& progress = {});

/// The labels of files beside a volume, on its grid. Throws as readSegmentations does.
Segmentation readBeside(const std::vector<std::filesystem::path>& files, const Volume& volume,
                        const Progress& progress = {});

/// Labels that were read beside what is kept of a volume: masks come to the masks that are open, which stay
/// shown as they are and are not read again (joinedMasks in MaskFolder.h), and other labels take the place of
/// those. Throws Cancelled.
FoundRegion openedBeside(const Region& kept, const Segmentation& opened, const Volume& volume,
                         const Progress& progress = {});

/// Whether labels of a file that a region had gave way to those of another.
bool replacesLabels(const Region& region, const Region& before);

/// What a scene asks to be kept of its volume; the label map is read from where the scene says. Throws Error
/// (input) where it cannot be read or lacks a label that has a weight; Cancelled.
FoundRegion regionOf(const KeptPart& part, const Volume& volume, const Progress& progress = {});

/// The same of a part whose files are where `written` names them or elsewhere: where labels cannot be shown
/// with the volume LabelsMissing tells of which file, by its name there.
FoundRegion regionOf(const KeptPart& part, const KeptPart& written, const Volume& volume,
                     const Progress& progress = {});

} // namespace limn
