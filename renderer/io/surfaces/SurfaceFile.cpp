// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceFile.h"

#include "io/reading/HeaderText.h"
#include "scene/basics/Error.h"

#include <bit>
#include <cstdio>
#include <cstring>
#include <ostream>

namespace limn {
namespace {

static_assert(std::endian::native == std::endian::little, "both binary formats store the least byte first");

/// Gathers what is written, and asks now and then whether to stop.
class Gathered {
public:
  Gathered(std::ostream& to, std::size_t pieces, const Progress& progress)
      : m_to(to), m_pieces(pieces), m_progress(progress) {}
  ~Gathered() { flush(); }
  Gathered(const Gathered&) = delete;
  Gathered& operator=(const Gathered&) = delete;

  template <class Value>
  void binary(const Value& value) {
    m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const char* format, auto... values) {
    char line[160];
    m_bytes.append(line, static_cast<std::size_t>(std::snprintf(line, sizeof line, format, values...)));
  }
  void line(const std::string& words) { m_bytes += words + "\n"; }

  // A point or a triangle is complete.
  void endPiece() {
    constexpr std::size_t most = 1 << 20;
    ++m_done;
    if (m_bytes.size() < most)
      return;
    flush();
    reportOrStop(m_progress, static_cast<double>(m_done) / static_cast<double>(m_pieces),
                 Message::tr("Writing the surface"));
  }

private:
  void flush() {
    m_to.write(m_bytes.data(), static_cast<std::streamsize>(m_bytes.size()));
    m_bytes.clear();
  }

  std::ostream& m_to;
  std::string m_bytes;
  std::size_t m_pieces, m_done = 0;
  const Progress& m_progress;
};

void writeStl(Gathered& out, const NamedSurface& surface) {
  char header[80] = {};
  std::strncpy(header, surface.description.c_str(), sizeof header - 1);
  out.binary(header);
  out.binary(static_cast<std::uint32_t>(surface.mesh->triangles.size()));
  for (const glm::uvec3& triangle : surface.mesh->triangles) {
    const glm::dvec3 area = areaVector(*surface.mesh, triangle);
    const double size = glm::length(area);
    out.binary(glm::vec3(size > 0.0 ? area / size : glm::dvec3(0.0)));
    for (int corner = 0; corner < 3; ++corner)
      out.binary(surface.mesh->points[triangle[corner]]);
    out.binary(std::uint16_t{0});
    out.endPiece();
  }
}

void writePly(Gathered& out, const NamedSurface& surface) {
  const SurfaceMesh& mesh = *surface.mesh;
  out.line("ply\nformat binary_little_endian 1.0\ncomment " + surface.description);
  out.line("element vertex " + std::to_string(mesh.points.size()));
  for (const char* property : {"x", "y", "z", "nx", "ny", "nz"})
    out.line(std::string("property float ") + property);
  out.line("element face " + std::to_string(mesh.triangles.size()));
  out.line("property list uchar int vertex_indices\nend_header");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    out.binary(mesh.points[i]);
    out.binary(mesh.normals[i]);
    out.endPiece();
  }
  for (const glm::uvec3& triangle : mesh.triangles) {
    out.binary(std::uint8_t{3});
    out.binary(triangle);
    out.endPiece();
  }
}

void writeObject(Gathered& out, const NamedSurface& surface, std::uint32_t before) {
  const SurfaceMesh& mesh = *surface.mesh;
  out.line("# " + surface.description);
  out.line("o " + surface.name);
  const auto three = [&](const char* format, const glm::vec3& v) {
    out.text(format, static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
    out.endPiece();
  };
  for (const glm::vec3& point : mesh.points)
    three("v %.9g %.9g %.9g\n", point);
  for (const glm::vec3& normal : mesh.normals)
    three("vn %.6g %.6g %.6g\n", normal);
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::uvec3 t = triangle + before + 1u;
    out.text("f %u//%u %u//%u %u//%u\n", t.x, t.x, t.y, t.y, t.z, t.z);
    out.endPiece();
  }
}

} // namespace

SurfaceFormat surfaceFormatOf(const std::filesystem::path& path) {
  const std::string ending = lowerCase(path.extension().string());
  if (ending == ".stl")
    return SurfaceFormat::stl;
  if (ending == ".ply")
    return SurfaceFormat::ply;
  if (ending == ".obj")
    return SurfaceFormat::obj;
  throw Error(Error::Kind::usage,
              Message::tr("Cannot write %1: its ending names no format of surfaces; use .stl, .ply or .obj.")
                  .arg(path.string()));
}

void writeSurfaces(std::ostream& to, SurfaceFormat format, const std::vector<NamedSurface>& surfaces,
                   const Progress& progress) {
  std::size_t pieces = 1;
  for (const NamedSurface& surface : surfaces)
    pieces += 2 * surface.mesh->points.size() + surface.mesh->triangles.size();
  Gathered out(to, pieces, progress);
  if (format == SurfaceFormat::stl)
    return writeStl(out, surfaces.front());
  if (format == SurfaceFormat::ply)
    return writePly(out, surfaces.front());
  std::uint32_t before = 0;
  for (const NamedSurface& surface : surfaces) {
    writeObject(out, surface, before);
    before += static_cast<std::uint32_t>(surface.mesh->points.size());
  }
}

} // namespace limn
