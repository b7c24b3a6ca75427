// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/Timing.h"
#include "app/lab/bench/Contender.h"
#include "app/lab/bench/PictureErrors.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// The view `index` of `count` on a full turn of the camera about its own up, the first as the scene has it.
Scene turned(const Scene& scene, int index, int count);

/// The scene with its middle control point a little fainter, by another amount for each index; nothing for a
/// function without points.
std::optional<Scene> edited(const Scene& scene, int index);

/// Draws a scene with every contender in turn: each afresh and after an edit for first frame and memory, then
/// `frames` views of one turn, then as many edits, renderer after renderer for each view and edit, so that
/// what disturbs the machine disturbs all. A contender that refuses the scene (Error, usage or openGl) gets a
/// row that says why; where all do, the first refusal is thrown. `advance` is called after every picture and
/// may throw.
std::vector<BenchRow> benchRows(const std::string& name, const Scene& scene,
                                const std::vector<std::unique_ptr<Contender>>& contenders, int frames,
                                const std::function<void()>& advance);

/// The pictures that benchRows draws with each contender.
inline int picturesPerRow(int frames) {
  return 2 + 2 * frames;
}

/// Rows as a table for the terminal, with the effects of each scene. Where VTK's mappers, or the program with
/// all effects, drew the same views, the share of their time that each took: the median over the views.
std::string benchTable(const std::string& machine, const std::vector<BenchRow>& rows);

/// The times at equal error as a table of their own.
std::string equalErrorTable(const std::vector<EqualErrorRow>& rows);

/// Which renderers take part.
struct BenchEntries {
  std::vector<std::string> engines{"gl"}; ///< gl, cpu, slices, reference, vtk-gpu, vtk-fixedpoint
  int threads = 0;                        ///< of the CPU engine and the reference, 0: every core
  bool allEffects = false;                ///< beside gl, the program with all effects compiled in
  std::vector<std::string> readOptions;   ///< how they are to read the volume, as on the command line
};

/// The renderers for one scene, whose volume is at `volumePath`, VTK's in processes of their own. Without
/// OpenGL those that need it are contenders that refuse every scene and say why, and the CPU engine is among
/// the others. Throws Error, also where renderers draw on different drivers: their times must not be
/// compared.
std::vector<std::unique_ptr<Contender>> contendersFor(const BenchEntries& entries,
                                                      const std::string& volumePath);

} // namespace limn
