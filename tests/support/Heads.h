// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/scenes/SimpleScenes.h"

#include <memory>
#include <string>

namespace limn::test {

using limn::headScene;
using limn::skinMuscleBone;

/// The CT head of the shared test data (its NIfTI-1 header read just far enough for this one file).
std::shared_ptr<const Volume> ctHead();
inline const char* const ctHeadFile = "data/ct_head_cranium/ct_head_cranium.nii.gz";

/// Air and soft tissue transparent, bone opaque, HU.
TransferFunction boneOnly();

} // namespace limn::test
