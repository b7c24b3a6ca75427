// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

namespace limn {

/// What an OpenGL object is.
enum class GlKind { texture, buffer, vertexArray, framebuffer, query, program };

// Make and end the name of an object, in the current context.
unsigned madeName(GlKind kind);
void endName(GlKind kind, unsigned name);

/// An OpenGL object that dies with its owner; move-only. Needs the context that made it to be current when it
/// dies.
template <GlKind kind>
class GlObject {
public:
  GlObject() : m_name(madeName(kind)) {}
  ~GlObject() {
    if (m_name != 0)
      endName(kind, m_name);
  }
  GlObject(GlObject&& other) noexcept : m_name(std::exchange(other.m_name, 0u)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(m_name, other.m_name);
    return *this;
  }

  unsigned name() const { return m_name; }

private:
  unsigned m_name = 0;
};

using GlTexture = GlObject<GlKind::texture>;
using GlBuffer = GlObject<GlKind::buffer>;
using GlVertexArray = GlObject<GlKind::vertexArray>;
using GlFramebuffer = GlObject<GlKind::framebuffer>;
using GlQuery = GlObject<GlKind::query>;
using GlProgram = GlObject<GlKind::program>;

} // namespace limn
