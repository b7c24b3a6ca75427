// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"

#include <glm/glm.hpp>

#include <memory>
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
  enum class Linking { finished, started };

  /// Compiles and links, or leaves it to the driver to do so in the background, if it can, until `finish`.
  /// Throws Error (openGl) with the driver's message by file and line.
  ShaderProgram(const ShaderSource& vertex, const ShaderSource& fragment,
                Linking linking = Linking::finished);

  /// Whether `finish` has been passed.
  bool isLinked() const { return !m_pending; }

  /// Whether `finish` would return at once. True where the driver cannot say.
  bool isReady() const;

  /// Waits for the driver; throws what the constructor would have thrown.
  void finish();

  ~ShaderProgram();
  ShaderProgram(ShaderProgram&&) noexcept;
  ShaderProgram& operator=(ShaderProgram&&) noexcept;

  void use() const;

  /// Sets a uniform of the program in use; one that the program does not have is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;

private:
  // What is needed until the driver's verdict is known.
  struct Pending;

  int location(const char* uniform) const;

  GlProgram m_program;
  std::unique_ptr<Pending> m_pending;
  mutable std::unordered_map<std::string, int> m_locations;
};

} // namespace limn
