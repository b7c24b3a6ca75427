// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/GlslEvaluator.h"

#include "gl/PictureTarget.h"
#include "gl/ShaderProgram.h"
#include "glsl/programs/SceneUniforms.h"
#include "glsl/programs/ShaderVariant.h"
#include "glsl/textures/SceneTextures.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

// The last of the units that every driver of OpenGL 3.0 has: no sampler of the ray caster uses it.
constexpr int argumentUnit = 15;

ShaderProgram programOf(const std::vector<std::string>& blocks, const std::string& functions,
                        const std::string& expression) {
  ShaderSource source;
  source.append("prelude", "#version 130\n");
  for (const std::string& block : blocks)
    source.append(block, embeddedShader(block));
  source.append("main",
                functions +
                    "\nuniform sampler2D u_arguments;\nout vec4 fragColor;\nvoid main() {\n"
                    "  vec4 v = texelFetch(u_arguments, ivec2(gl_FragCoord.xy), 0);\n  fragColor = vec4(" +
                    expression + ");\n}\n");
  return {vertexSource(), source};
}

GlTexture rowOfTexels(GLsizei count, const glm::vec4* texels) {
  GlTexture made;
  glBindTexture(GL_TEXTURE_2D, made.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, count, 1, 0, GL_RGBA, GL_FLOAT, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return made;
}

// Draws one pixel per argument with a program whose other uniforms are set.
std::vector<glm::vec4> drawn(const ShaderProgram& program, const std::vector<glm::vec4>& arguments) {
  const auto count = static_cast<GLsizei>(arguments.size());
  glActiveTexture(GL_TEXTURE0 + argumentUnit);
  const GlTexture input = rowOfTexels(count, arguments.data());
  const GlTexture output = rowOfTexels(count, nullptr);
  glBindTexture(GL_TEXTURE_2D, input.name());
  program.set("u_arguments", argumentUnit);
  const GlFramebuffer framebuffer;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, output.name(), 0);
  const float triangle[] = {-1.0f, -1.0f, 3.0f, -1.0f, -1.0f, 3.0f};
  const GlVertexArray vertexArray;
  const GlBuffer corners;
  glBindVertexArray(vertexArray.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners.name());
  glBufferData(GL_ARRAY_BUFFER, sizeof(triangle), triangle, GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glViewport(0, 0, count, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<glm::vec4> values(arguments.size());
  glReadPixels(0, 0, count, 1, GL_RGBA, GL_FLOAT, values.data());
  glActiveTexture(GL_TEXTURE0);
  glUseProgram(0); // it goes with this call
  return values;
}

} // namespace

std::vector<glm::vec4> GlslEvaluator::operator()(const std::string& expression,
                                                 const std::vector<glm::vec4>& arguments) const {
  const SavedState saved; // or the next picture would be told to return to a program that is gone
  const ShaderProgram program = programOf(m_blocks, m_functions, expression);
  program.use();
  return drawn(program, arguments);
}

std::vector<glm::vec4> GlslEvaluator::operator()(const std::string& expression,
                                                 const std::vector<glm::vec4>& arguments,
                                                 const Scene& scene) const {
  const SavedState saved;
  SceneTextures textures;
  textures.update(scene);
  const ShaderProgram program = programOf(m_blocks, m_functions, expression);
  program.use();
  setUniforms(program, scene, {1, 1}, textures);
  bindTextures(textures);
  return drawn(program, arguments);
}

} // namespace limn
