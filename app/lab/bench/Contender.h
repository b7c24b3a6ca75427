// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/drawing/ProcessCost.h"
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "scene/Scene.h"
#include "scene/basics/Image.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace limn {

/// One renderer in a benchmark. Pictures have the size that the scene's image settings name.
class Contender {
public:
  virtual ~Contender() = default;

  /// The name in the table: "limn-gl", "vtk-gpu", …
  virtual std::string program() const = 0;

  /// What the pictures are drawn on, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  virtual std::string renderer() const = 0;

  /// The effects in the program that draws `scene`, in words; empty where there is no choice.
  virtual std::string effects(const Scene&) { return {}; }

  /// Whether it lights both sides of a surface whatever the scene says, as VTK's mappers do.
  virtual bool lightsBothSides() const { return false; }

  /// Lets go of everything made so far, then draws a first picture: upload, preparation, shader and frame.
  /// Throws Error (usage) naming what this renderer cannot draw.
  virtual FrameCost drawFirst(const Scene& scene) = 0;

  /// Draws a scene that differs from the one before in camera and transfer function at most.
  virtual FrameCost draw(const Scene& scene) = 0;

  /// The most memory resident since before `drawFirst`, above what was resident then, MB.
  virtual double peakMb() = 0;

  /// Writes the picture drawn last, over the scene's background.
  virtual void save(const std::filesystem::path& path) = 0;
};

/// Limn's GLSL ray caster, specialised ("limn-gl") or with all effects compiled in ("limn-gl-all"); a frame
/// ends with glFinish. Contenders of one process share the context.
std::unique_ptr<Contender> glContender(std::shared_ptr<HeadlessContext> context,
                                       RayCaster::Programs programs);

/// Draws a whole picture and returns it.
using DrawPicture = std::function<Image(const Scene&)>;

/// Makes a renderer afresh.
using StartDrawing = std::function<DrawPicture()>;

/// Any other renderer of Limn; a frame ends when its picture is there.
std::unique_ptr<Contender> pictureContender(const std::string& program, const std::string& renderer,
                                            StartDrawing start);

/// A renderer that cannot be had here: refuses every scene with `reason`, one sentence (Error, usage).
std::unique_ptr<Contender> absentContender(const std::string& program, const std::string& reason);

/// How to start a program that draws with another library.
struct RivalCommand {
  std::filesystem::path program;
  std::vector<std::string> arguments; ///< the mapper and how to read the volume
};

/// A renderer of another library in a process of its own, which lives as long as this object, so that its
/// pictures alternate with ours. It is told on stdin `first N` or `draw N` and N bytes of scene JSON (whose
/// volume is `volumePath`), `peak`, or `save PATH`, and answers each with a line: `ok` and its numbers (ms
/// and ms of processor, or MB), or `error` and a sentence. Its first line is `ok` and its renderer string.
/// Throws Error where it cannot be started or draws nothing.
std::unique_ptr<Contender> rivalContender(const std::string& name, const RivalCommand& command,
                                          const std::string& volumePath);

} // namespace limn
