# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, a C++ file with the text of every file of PRESETS (a list joined by commas).
string(REPLACE "," ";" PRESETS "${PRESETS}")
set(text "// Made by EmbedPresets.cmake from the folder presets.\n#include <string>\n#include <utility>\n#include <vector>\n\n")
string(APPEND text "namespace limn {\n\nstd::vector<std::pair<std::string, std::string>> embeddedPresets();\n\n")
string(APPEND text "std::vector<std::pair<std::string, std::string>> embeddedPresets() {\n  return {\n")
foreach(preset ${PRESETS})
  get_filename_component(name "${preset}" NAME_WE)
  file(READ "${preset}" body)
  string(APPEND text "      {\"${name}\", R\"json(${body})json\"},\n")
endforeach()
string(APPEND text "  };\n}\n\n} // namespace limn\n")
file(WRITE "${OUTPUT}" "${text}")
