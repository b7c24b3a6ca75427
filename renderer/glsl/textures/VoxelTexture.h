// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "scene/basics/Message.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace limn {

/// A 3D texture of four channels, read with linear interpolation, beside the texture of a volume and of the
/// same size.
class VoxelTexture {
public:
  enum class Format { halves, bytes };

  /// Writes the texels of slice k, x fastest.
  using FillSlice = std::function<void(int k, std::vector<glm::vec4>& texels)>;

  /// Uploads slice by slice, which needs no second copy of the whole. `what` names it in the Error (openGl)
  /// that is thrown where the driver has no room for it.
  VoxelTexture(const glm::ivec3& size, Format format, const Message& what, const FillSlice& fill);

  unsigned name() const { return m_texture.name(); }
  std::size_t bytes() const { return m_bytes; }

private:
  GlTexture m_texture;
  std::size_t m_bytes = 0;
};

} // namespace limn
