// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/LabelSurfaces.h"

#include "io/surfaces/SurfaceFile.h"

#include <algorithm>
#include <set>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestStem = 100;

std::string fileNameOf(std::string name) {
  for (char& letter : name)
    if (static_cast<unsigned char>(letter) <= ' ' ||
        std::string_view("/\\:*?\"<>|\x7f").find(letter) != std::string_view::npos)
      letter = '_';
  return name.substr(0, longestStem);
}

} // namespace

std::vector<LabelSurface> labelSurfaces(const Region& region, const fs::path& path) {
  std::vector<LabelSurface> surfaces;
  std::set<std::string> taken;
  for (std::size_t place = 0; place < ownLabels(region); ++place) {
    const Label& label = region.labels->labels()[place];
    const VoxelBox& box = region.labels->boxAround(place);
    if (label.value == 0 || box.lower == box.upper)
      continue;
    std::string name = fileNameOf(label.name);
    if (!taken.insert(name).second)
      name.append("_").append(std::to_string(label.value));
    taken.insert(name);
    fs::path file = path;
    file.replace_filename(path.stem().string() + "_" + name + path.extension().string());
    surfaces.push_back({place, label.name, file});
  }
  return surfaces;
}

Scene sceneOfLabel(const Region& labels, std::size_t place, const Grid& grid) {
  const LabelMap& map = *labels.labels;
  // With a voxel around it that has another label, where the volume has one.
  const VoxelBox box = widened(map.boxAround(place), grid);
  const glm::ivec3 size = box.upper - box.lower;
  std::vector<std::uint8_t> voxels;
  voxels.reserve(static_cast<std::size_t>(size.x) * size.y * size.z);
  for (int z = box.lower.z; z < box.upper.z; ++z)
    for (int y = box.lower.y; y < box.upper.y; ++y)
      for (int x = box.lower.x; x < box.upper.x; ++x)
        voxels.push_back(map.placeAt(voxelOffset(map.dims(), x, y, z)) == place ? 1 : 0);
  Scene scene;
  scene.volume = std::make_shared<const Volume>(partOf(grid, box), std::move(voxels), Rescale{}, std::nullopt,
                                                VolumeInfo{});
  return scene;
}

std::vector<WrittenSurface> exportLabelSurfaces(const Region& labels, const Grid& grid,
                                                const std::vector<LabelSurface>& surfaces, SurfaceOrder order,
                                                const Progress& progress) {
  order.isovalue = 0.5;
  std::vector<WrittenSurface> written;
  for (const LabelSurface& surface : surfaces) {
    const double share = 1.0 / static_cast<double>(surfaces.size());
    const auto done = static_cast<double>(written.size());
    const Scene one = sceneOfLabel(labels, surface.place, grid);
    std::vector<WrittenSurface> made =
        exportSurfaces(one, {order}, surface.file, part(progress, share * done, share * (done + 1.0)));
    written.push_back(std::move(made.front()));
  }
  return written;
}

} // namespace limn
