// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/openimageio/PictureLibrary.h"

#include "scene/basics/Error.h"

#include <dlfcn.h>

namespace limn {
namespace {

// Found beside the program: its RUNPATH names the folder.
const PictureLibrary* loaded() {
  void* module = dlopen("liblimn_picture_files.so", RTLD_NOW | RTLD_LOCAL);
  const void* found = module ? dlsym(module, "limnPictureLibrary") : nullptr;
  if (!found) {
    const char* reason = dlerror();
    throw Error(Error::Kind::other, std::string("Pictures can be neither read nor written, because a part of "
                                                "Limn cannot be loaded (") +
                                        (reason ? reason : "no reason given") + "); install Limn again.");
  }
  return static_cast<const PictureLibrary*>(found);
}

} // namespace

const PictureLibrary& pictureLibrary() {
  static const PictureLibrary* library = loaded();
  return *library;
}

} // namespace limn
