// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engines/ProcessCost.h"
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "scene/Scene.h"
#include "scene/basics/Image.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

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

} // namespace limn
