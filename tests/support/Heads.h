// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <memory>
#include <string>

namespace limn::test {

/// The CT head of the shared test data (its NIfTI-1 header read just far enough for this one file).
std::shared_ptr<const Volume> ctHead();
inline const char* const ctHeadFile = "data/ct_head_cranium/ct_head_cranium.nii.gz";

/// Skin faint, muscle fuller, bone dense: the transfer function of the comparisons, HU.
TransferFunction skinMuscleBone();

/// Air and soft tissue transparent, bone opaque, HU.
TransferFunction boneOnly();

/// A volume seen by the default camera under skinMuscleBone, step 0.25, without early termination.
Scene headScene(std::shared_ptr<const Volume> volume, ShadingModel model);

} // namespace limn::test
