// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/openimageio/PictureLibrary.h"

#include "scene/basics/Error.h"

#include <dlfcn.h>
#include <sys/mman.h>

namespace limn {
namespace {

// What the library and all that it brings along map, threads included. One of those libraries starts threads
// while it is loaded, and ends or holds up the program where the system has no memory for them.
constexpr std::size_t mappedByLibrary = std::size_t{384} << 20;

bool hasRoomForLibrary() {
  void* room = mmap(nullptr, mappedByLibrary, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED)
    return false;
  munmap(room, mappedByLibrary);
  return true;
}

// Found beside the program: its RUNPATH names the folder.
const PictureLibrary* loaded() {
  if (!hasRoomForLibrary())
    throw Error(
        Error::Kind::other,
        Message::tr("Pictures can be neither read nor written, because there is not enough memory for the "
                    "part of Limn that does it; close other programs or allow Limn more memory."));
  void* module = dlopen("liblimn_picture_files.so", RTLD_NOW | RTLD_LOCAL);
  const void* found = module ? dlsym(module, "limnPictureLibrary") : nullptr;
  if (!found) {
    const char* reason = dlerror();
    throw Error(Error::Kind::other, Message::tr("Pictures can be neither read nor written, because a part of "
                                                "Limn cannot be loaded (%1); install Limn again.")
                                        .arg(reason ? Message(reason) : Message::tr("no reason given")));
  }
  return static_cast<const PictureLibrary*>(found);
}

} // namespace

const PictureLibrary& pictureLibrary() {
  static const PictureLibrary* library = loaded();
  return *library;
}

} // namespace limn
