// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "NullCompiler.h"
#include "gl/ShaderProgram.h"

namespace limn::test {

/// A program of GLSL 1.30 as Vulkan takes it.
struct SpirvProgram {
  Spirv vertex;
  Spirv fragment;
};

/// Translates a program: textures and uniforms get places, and the text stays as it is, but for its version.
/// The translator is glslang as a library: its command would read the language's own functions anew for each
/// program, which takes a hundred times as long. Throws std::runtime_error with the file and line of the
/// block that is refused.
SpirvProgram spirvOf(const ShaderSource& vertex, const ShaderSource& fragment);

} // namespace limn::test
