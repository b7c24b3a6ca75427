// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace limn {

/// Evaluates GLSL expressions in a fragment program, one value per pixel of a target of floats. Needs a
/// current context.
class GlslEvaluator {
public:
  /// The building blocks of the folder shaders that the expressions call, and functions of one's own.
  explicit GlslEvaluator(std::vector<std::string> blocks, std::string functions = {})
      : m_blocks(std::move(blocks)), m_functions(std::move(functions)) {}

  /// The value of an expression of `vec4 v` for each argument; a float fills all four channels.
  std::vector<glm::vec4> operator()(const std::string& expression,
                                    const std::vector<glm::vec4>& arguments) const;

  /// The same with the volume and the transfer function of a scene bound, as the ray caster binds them.
  std::vector<glm::vec4> operator()(const std::string& expression, const std::vector<glm::vec4>& arguments,
                                    const Scene& scene) const;

private:
  std::vector<std::string> m_blocks;
  std::string m_functions;
};

} // namespace limn
