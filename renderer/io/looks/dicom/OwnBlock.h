// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/Items.h"
#include "io/scenefile/SceneFile.h"

// What a look keeps for Limn itself (README.md, "The private block").

namespace limn::dicom {

/// Writes the scene's numbers for the object of that instance UID: no path, no name of a file.
void putOwnBlock(DcmItem& object, const Scene& scene, const std::string& instance);

/// The scene as it was written, without its volume; nothing where there is no such block. One of a later
/// version, or copied from another object, is left aside with a sentence. Throws Error (input) where it is
/// damaged.
std::optional<SceneDocument> ownBlockIn(DcmItem& object, const std::string& name,
                                        std::vector<Message>& changes);

} // namespace limn::dicom
