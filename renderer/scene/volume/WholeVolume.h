// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Error.h"
#include "scene/volume/Volume.h"

namespace limn {

/// Throws Error (input) where voxels were lost since the volume was read: its file became shorter, or a disk
/// failed. To be asked before what was made of it is shown or written, where its file is not known by name.
inline void requireWhole(const Volume& volume) {
  if (!volume.isWhole())
    throw Error(Error::Kind::input, Message::tr("The volume's file became shorter while it was read, or its "
                                                "disk failed; copy the file again and open it anew."));
}

} // namespace limn
