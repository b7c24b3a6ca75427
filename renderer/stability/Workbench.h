// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/CpuRenderer.h"
#include "engine/Engine.h"
#include "raycaster/RayCaster.h"
#include "slices/SliceRenderer.h"
#include "stability/HardCase.h"

#include <functional>
#include <optional>

namespace limn {

/// A picture as any engine draws it: premultiplied RGBA without background, rows from the top.
struct DrawnPicture {
  glm::ivec2 size{0};
  std::vector<glm::dvec4> pixels;
  bool operator==(const DrawnPicture&) const = default;

  const glm::dvec4& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * size.x + x]; }
};

/// The renderers, kept from one case to the next as in the window: state left behind by one picture would
/// show in the next.
class Workbench {
public:
  /// `withoutOpenGl`: the sentence that says why there is no OpenGL. Where it is empty a context of at least
  /// 3.0 is current while this lives.
  explicit Workbench(std::string withoutOpenGl = {}) : m_withoutOpenGl(std::move(withoutOpenGl)) {}

  bool hasOpenGl() const { return m_withoutOpenGl.empty(); }

  /// Throws Error (usage) that says why there is none.
  void requireOpenGl() const;

  /// Throws Error, of kind usage where OpenGL draws and there is none; so do `rays` and `slices`.
  DrawnPicture draw(Engine engine, const Scene& scene, const glm::ivec2& size);

  RayCaster& rays();
  SliceRenderer& slices();
  CpuRenderer& processor();

private:
  std::string m_withoutOpenGl;
  std::optional<RayCaster> m_rays;
  std::optional<SliceRenderer> m_slices;
  std::optional<CpuRenderer> m_processor;
};

/// What each engine's figure must not exceed.
struct Bounds {
  double reference = 0.0;
  double gl = 0.0; ///< rays in floats: in GLSL and on the processor
  double slices = 0.0;
};

/// Draws with the engine that is being measured.
using Draw = std::function<DrawnPicture(const Scene& scene, const glm::ivec2& size)>;

/// One finding per engine: `figure` draws what it needs and returns what must not exceed the engine's bound.
/// An engine that refuses the scene by name (Error, usage) does not apply, with that sentence. The first two
/// pictures of at least 16 pixels each way are kept for the report.
std::vector<Finding> inEachEngine(Workbench& bench, const std::string& what, const Bounds& bounds,
                                  const std::string& reason,
                                  const std::function<double(const Draw& draw)>& figure);

/// The same for the engines named.
std::vector<Finding> inEngines(Workbench& bench, const std::vector<Engine>& engines, const std::string& what,
                               const Bounds& bounds, const std::string& reason,
                               const std::function<double(const Draw& draw)>& figure);

/// The finding that `measure` makes with OpenGL, or one that says why there is none.
Finding withOpenGl(const Workbench& bench, const std::string& engine, const std::string& what,
                   const std::function<Finding()>& measure);

/// Appends findings to others.
std::vector<Finding>& operator+=(std::vector<Finding>& findings, std::vector<Finding> more);

/// A picture over a background as the window puts it on the screen, in a framebuffer of 8 bits a channel;
/// rows from the top. Needs a current context.
std::vector<glm::u8vec4> presented(const DrawnPicture& picture, const glm::dvec3& background);

} // namespace limn
