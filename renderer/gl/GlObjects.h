// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

namespace limn {

/// An OpenGL object that dies with its owner; move-only. Needs the context that made it to be current when it
/// dies. `Kind` names the object and how it is made and deleted.
template <class Kind>
class GlObject {
public:
  GlObject() : m_name(Kind::create()) {}
  ~GlObject() {
    if (m_name != 0)
      Kind::destroy(m_name);
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

/// What makes and ends the names of each kind of object, in the current context.
struct TextureKind {
  static unsigned create();
  static void destroy(unsigned name);
};
struct BufferKind {
  static unsigned create();
  static void destroy(unsigned name);
};
struct VertexArrayKind {
  static unsigned create();
  static void destroy(unsigned name);
};
struct FramebufferKind {
  static unsigned create();
  static void destroy(unsigned name);
};
struct ProgramKind {
  static unsigned create();
  static void destroy(unsigned name);
};
struct QueryKind {
  static unsigned create();
  static void destroy(unsigned name);
};

using GlTexture = GlObject<TextureKind>;
using GlBuffer = GlObject<BufferKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlFramebuffer = GlObject<FramebufferKind>;
using GlProgram = GlObject<ProgramKind>;
using GlQuery = GlObject<QueryKind>;

} // namespace limn
