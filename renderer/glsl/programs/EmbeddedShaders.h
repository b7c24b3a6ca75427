// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace limn {

/// A file of the folder shaders, carried in the binary.
struct EmbeddedShader {
  std::string name;
  std::string text;
};

/// All of them, by names such as "march.glsl" and "decisions/volume_wide.glsl".
const std::vector<EmbeddedShader>& embeddedShaders();

/// The text of one file; it must exist.
const std::string& embeddedShader(const std::string& name);

} // namespace limn
