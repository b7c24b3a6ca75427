// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/ShaderProgram.h"

#include "gl/DriverHealth.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace limn {

// A shader object lives until its program is linked.
struct ShaderObject {
  explicit ShaderObject(GLenum stage) : name(glCreateShader(stage)) {}
  ~ShaderObject() { glDeleteShader(name); }
  ShaderObject(const ShaderObject&) = delete;
  ShaderObject& operator=(const ShaderObject&) = delete;
  GLuint name;
};

namespace {

// Of a shader or a program, whose functions are given.
template <class GetNumber, class GetLog>
std::string logOf(GLuint object, GetNumber getNumber, GetLog getLog) {
  GLint length = 0;
  getNumber(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  getLog(object, length, nullptr, log.data());
  return log.c_str();
}

void startCompiling(const ShaderObject& shader, const ShaderSource& source) {
  const char* text = source.text.c_str();
  glShaderSource(shader.name, 1, &text, nullptr);
  glCompileShader(shader.name);
}

void requireCompiled(const ShaderObject& shader, const ShaderSource& source) {
  GLint isCompiled = GL_FALSE;
  glGetShaderiv(shader.name, GL_COMPILE_STATUS, &isCompiled);
  if (isCompiled != GL_TRUE)
    throw DriverError(Message::tr("The graphics driver refused a shader; update the driver or use --engine "
                                  "cpu, and please report it with `limn info --system`."),
                      withFileLines(logOf(shader.name, glGetShaderiv, glGetShaderInfoLog), source));
}

} // namespace

void ShaderSource::append(const std::string& file, const std::string& block) {
  text += block;
  int number = 0;
  std::istringstream stream(block);
  for (std::string line; std::getline(stream, line);)
    lines.push_back({file, ++number});
}

std::string withFileLines(const std::string& log, const ShaderSource& source) {
  // The number after the source string's number: "0:12", "0(12)".
  static const std::regex place(R"((^|\s)0[:(](\d+)\)?)");
  std::istringstream stream(log);
  std::string translated;
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, place)) {
      const auto number = static_cast<std::size_t>(std::stoul(match[2]));
      if (number >= 1 && number <= source.lines.size()) {
        const ShaderSource::Line& origin = source.lines[number - 1];
        line = match.prefix().str() + match[1].str() + origin.file + ":" + std::to_string(origin.line) +
               match.suffix().str();
      }
    }
    translated += line + "\n";
  }
  return translated;
}

struct ShaderProgram::Pending {
  ShaderSource vertexSource;
  ShaderSource fragmentSource;
  ShaderObject vertex{GL_VERTEX_SHADER};
  ShaderObject fragment{GL_FRAGMENT_SHADER};
};

ShaderProgram::ShaderProgram(const ShaderSource& vertex, const ShaderSource& fragment, Linking linking)
    : m_pending(new Pending{vertex, fragment}) {
  // No question before `finish`: each would make the driver wait for its own threads.
  startCompiling(m_pending->vertex, vertex);
  startCompiling(m_pending->fragment, fragment);
  glAttachShader(m_program.name(), m_pending->vertex.name);
  glAttachShader(m_program.name(), m_pending->fragment.name);
  glBindAttribLocation(m_program.name(), 0, "a_corner");
  glBindFragDataLocation(m_program.name(), 0, "fragColor");
  glLinkProgram(m_program.name());
  if (linking == Linking::finished)
    finish();
}

ShaderProgram::~ShaderProgram() = default;
ShaderProgram::ShaderProgram(ShaderProgram&&) noexcept = default;
ShaderProgram& ShaderProgram::operator=(ShaderProgram&&) noexcept = default;

bool ShaderProgram::isReady() const {
  const bool canTell = epoxy_has_gl_extension("GL_KHR_parallel_shader_compile") ||
                       epoxy_has_gl_extension("GL_ARB_parallel_shader_compile");
  if (!m_pending || !canTell)
    return true;
  GLint isComplete = GL_FALSE;
  glGetProgramiv(m_program.name(), GL_COMPLETION_STATUS_ARB, &isComplete);
  return isComplete == GL_TRUE;
}

void ShaderProgram::finish() {
  if (!m_pending)
    return;
  requireCompiled(m_pending->vertex, m_pending->vertexSource);
  requireCompiled(m_pending->fragment, m_pending->fragmentSource);
  GLint isLinked = GL_FALSE;
  glGetProgramiv(m_program.name(), GL_LINK_STATUS, &isLinked);
  glDetachShader(m_program.name(), m_pending->vertex.name);
  glDetachShader(m_program.name(), m_pending->fragment.name);
  if (isLinked != GL_TRUE)
    throw DriverError(Message::tr("The graphics driver could not link a shader program; update the driver or "
                                  "use --engine cpu, and please report it with `limn info --system`."),
                      logOf(m_program.name(), glGetProgramiv, glGetProgramInfoLog));
  m_pending.reset();
}

void ShaderProgram::use() const {
  glUseProgram(m_program.name());
}

int ShaderProgram::location(const char* uniform) const {
  const auto known = m_locations.find(uniform);
  if (known != m_locations.end())
    return known->second;
  return m_locations[uniform] = glGetUniformLocation(m_program.name(), uniform);
}

void ShaderProgram::set(const char* uniform, int value) const {
  glUniform1i(location(uniform), value);
}
void ShaderProgram::set(const char* uniform, float value) const {
  glUniform1f(location(uniform), value);
}
void ShaderProgram::set(const char* uniform, const glm::vec2& value) const {
  glUniform2f(location(uniform), value.x, value.y);
}
void ShaderProgram::set(const char* uniform, const glm::vec3& value) const {
  glUniform3f(location(uniform), value.x, value.y, value.z);
}

} // namespace limn
