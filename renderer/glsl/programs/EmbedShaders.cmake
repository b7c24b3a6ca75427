# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, a C++ file with the text of every file of SHADERS (a list joined by commas).
string(REPLACE "," ";" SHADERS "${SHADERS}")
set(text "// Made by EmbedShaders.cmake from the folder shaders.\n#include \"glsl/programs/ShaderVariant.h\"\n\n")
string(APPEND text "namespace limn {\n\nconst std::vector<EmbeddedShader>& embeddedShaders() {\n")
string(APPEND text "  static const std::vector<EmbeddedShader> shaders = {\n")
foreach(shader ${SHADERS})
  get_filename_component(name "${shader}" NAME)
  file(READ "${shader}" body)
  string(APPEND text "      {\"${name}\", R\"glsl(${body})glsl\"},\n")
endforeach()
string(APPEND text "  };\n  return shaders;\n}\n\n} // namespace limn\n")
file(WRITE "${OUTPUT}" "${text}")
