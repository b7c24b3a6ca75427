// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/OnDisk.h"

#include "scene/basics/Error.h"
#include "scene/basics/MemoryBudget.h"

namespace limn {
namespace {

std::uint64_t bytesOf(const Volume& volume) {
  return visitVoxels(volume, []<class T>(const StoredVoxels<T>& stored) -> std::uint64_t {
    return stored.size() * sizeof(T);
  });
}

} // namespace

bool staysOnDisk(const Scene& scene) {
  return scene.volume && scene.volume->room();
}

void requireOpenGlMayCopy(const Scene& scene, const std::string& otherwise) {
  if (!staysOnDisk(scene))
    return;
  const glm::ivec3& dims = scene.volume->grid().dims;
  throw Error(Error::Kind::usage, "OpenGL would copy the volume of " + std::to_string(dims.x) + " x " +
                                      std::to_string(dims.y) + " x " + std::to_string(dims.z) +
                                      " voxels, which stays on disk, into memory; " + otherwise +
                                      "give it memory with --memory " +
                                      std::to_string(MemoryBudget::leastMbFor(bytesOf(*scene.volume))) + ".");
}

} // namespace limn
