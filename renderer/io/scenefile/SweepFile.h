// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

/// Many pictures: every volume with every preset, model and view, and each of those from all around. An empty
/// list leaves its choice to `limn render`.
struct Sweep {
  std::vector<std::string> volumes; ///< whatever `limn render` takes as SOURCE
  std::vector<std::string> presets; ///< names, or files of looks
  std::vector<std::string> models;
  std::vector<std::string> views;
  int turntable = 0;          ///< pictures of one turn; 0: none but the first
  std::string size;           ///< "WIDTHxHEIGHT"; empty: the scene's
  std::string keep;           ///< "all" or "body"; empty: the scene's
  double tolerance = 0.0;     ///< levels; 0: not given
  double stepVoxels = 0.0;    ///< 0: not given
  std::string engine = "cpu"; ///< whose bits are the same on every machine, whatever its driver
  int threads = 0;            ///< of each picture; 0: every core
  std::string format = "png";
  std::string folder; ///< of the pictures
  bool operator==(const Sweep&) const = default;
};

/// Reads the text of a sweep file: `{"limn_sweep": 1, "volumes": […], "presets": […], "models": […], "views":
/// […], "turntable": 36, "size": "800x600", "keep": "body", "tolerance_levels": 1, "step_voxels": 0.5,
/// "engine": "cpu", "threads": 1, "format": "png", "output": "pictures"}`, each key but the first optional.
/// `name` is how errors call it. Throws Error (input).
Sweep parseSweep(std::string_view text, const std::string& name);

/// Reads a sweep file; volumes, files of looks that lie beside it, and the folder become absolute.
Sweep readSweepFile(const std::filesystem::path& path);

} // namespace limn
