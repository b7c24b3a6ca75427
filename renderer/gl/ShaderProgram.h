// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"

#include <glm/glm.hpp>

#include <string>
#include <unordered_map>
#include <vector>

namespace limn {

/// GLSL text assembled from files, and where each of its lines comes from. Mesa ignores the source number of
/// `#line`, so messages are translated through this table instead.
struct ShaderSource {
  struct Line {
    std::string file;
    int line = 0; ///< from 1
  };
  std::string text;
  std::vector<Line> lines; ///< one per line of `text`

  /// Appends a text whose lines belong to `file`; it should end with a newline.
  void append(const std::string& file, const std::string& block);
};

/// Replaces the line numbers of a driver's log ("0:12(3): error", "0(12) : error", "ERROR: 0:12:") by
/// "file:line".
std::string withFileLines(const std::string& log, const ShaderSource& source);

/// A linked GLSL 1.30 program whose only attribute is `a_corner` at 0 and whose output is `fragColor`.
class ShaderProgram {
public:
  /// Compiles and links; throws Error (openGl) with the driver's message by file and line.
  ShaderProgram(const ShaderSource& vertex, const ShaderSource& fragment);

  void use() const;

  /// Sets a uniform of the program in use; one that the program does not have is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;

private:
  int location(const char* uniform) const;

  GlProgram m_program;
  mutable std::unordered_map<std::string, int> m_locations;
};

} // namespace limn
