// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace limn {

/// Remembers the OpenGL state that drawing a picture changes and puts it back when it dies, for contexts that
/// are shared with a toolkit. Texture bindings are kept of the first `textureUnits` units. The constructor
/// sets what exact pixels need: no blending, depth, stencil or face test, no dithering, all channels written.
class SavedState {
public:
  SavedState();
  ~SavedState();
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;

  static constexpr int textureUnits = 10;
  static constexpr int capabilities = 7;

private:
  std::array<unsigned char, capabilities> m_enabled{};
  std::array<unsigned char, 4> m_colorMask{};
  std::array<int, textureUnits> m_textures2D{};
  std::array<int, textureUnits> m_textures3D{};
  std::array<int, 4> m_viewport{};
  std::array<int, 4> m_scissorBox{};
  int m_program = 0;
  int m_vertexArray = 0;
  int m_arrayBuffer = 0;
  int m_activeTexture = 0;
  int m_unpackAlignment = 4;
  int m_unpackBuffer = 0;
  std::array<int, 4> m_blendFactors{};
  std::array<int, 2> m_blendEquations{};
};

} // namespace limn
