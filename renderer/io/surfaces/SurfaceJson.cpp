// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceExport.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson distancesJson(const Distances& distances) {
  return {{"largest", distances.largest}, {"mean", distances.mean}, {"points", distances.points}};
}

OrderedJson surfaceJson(const WrittenSurface& surface) {
  const MadeSurface& made = surface.made;
  return {
      {"value", made.order.isovalue},
      {"file", surface.file.filename().string()},
      {"triangles", made.mesh.triangles.size()},
      {"triangles_before", made.trianglesBefore},
      {"closed", made.order.isClosed},
      {"watertight", made.edges.isWatertight()},
      {"edges_of_holes", made.edges.usedOnce},
      {"edges_used_otherwise", made.edges.usedOtherwise},
      {"volume_mm3", made.edges.isWatertight() ? OrderedJson(made.enclosedMm3) : OrderedJson()},
      {"parts", made.parts},
      {"dropped",
       {{"parts", made.dropped.parts},
        {"hollows", made.dropped.hollows},
        {"volume_mm3", made.dropped.enclosedMm3}}},
      {"tolerance_mm", made.order.toleranceMm > 0.0 ? OrderedJson(made.order.toleranceMm) : OrderedJson()},
      {"distance_mm",
       {{"largest", made.error.largest()},
        {"mesh_to_surface", distancesJson(made.error.ofMesh)},
        {"surface_to_mesh", distancesJson(made.error.ofSurface)}}}};
}

} // namespace

std::string surfacesJson(const std::vector<WrittenSurface>& surfaces) {
  OrderedJson list = OrderedJson::array();
  for (const WrittenSurface& surface : surfaces)
    list.push_back(surfaceJson(surface));
  return OrderedJson{{"axes", "LPS"}, {"unit", "mm"}, {"surfaces", list}}.dump(2) + "\n";
}

} // namespace limn
