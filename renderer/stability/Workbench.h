// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/CpuRenderer.h"
#include "engine/Engine.h"
#include "raycaster/RayCaster.h"
#include "scene/basics/Image.h"
#include "slices/SliceRenderer.h"
#include "stability/scenes/SimpleScenes.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// How a row of the report ends.
enum class Verdict { pass, fail, notApplicable };

/// "pass", "fail" or "n/a".
std::string verdictText(Verdict verdict);

/// One row of the report on a hard case.
struct Finding {
  std::string engine;  ///< "reference", "gl", "slices"; "cpp", "glsl" for functions that draw nothing
  std::string what;    ///< which of the case's settings; may be empty
  double figure = 0.0; ///< measured
  double bound = 0.0;  ///< which the figure must not exceed
  Verdict verdict = Verdict::notApplicable;
  std::string reason; ///< what the figure is and where the bound comes from, or why the case cannot apply
  std::vector<Image> pictures{}; ///< what was drawn, at most two, where there is something to see
};

/// Passes where `figure` ≤ `bound`; a figure that is not a number fails.
Finding atMost(std::string engine, std::string what, double figure, double bound, std::string reason);

/// A row for an engine, or a setting, that a case cannot be asked of; `reason` says why.
Finding notApplicable(std::string engine, std::string what, std::string reason);

class Workbench;

/// A situation in which volume renderers are known to fail, as a scene or an input with a bound: a row of
/// the report for each renderer that can draw it, and for each of the settings that it names.
struct HardCase {
  std::string id;    ///< "H1", stable from version to version
  std::string title; ///< the situation and what must hold, for people
  std::vector<Finding> (*measure)(Workbench& bench);
};

/// What was measured of a case.
struct MeasuredCase {
  std::string id;
  std::string title;
  std::vector<Finding> findings;
};

/// Told how far long work is, 0..1, and what it does; throws Cancelled to end it.
using ReportStability = std::function<void(double fraction, const std::string& doing)>;

/// Measures cases one after the other. A case that ends with an error has failed, with the error's sentence;
/// Cancelled passes through.
std::vector<MeasuredCase> measure(const std::vector<HardCase>& cases, Workbench& bench,
                                  const ReportStability& report = {});

/// Whether no finding of any case failed.
bool allHold(const std::vector<MeasuredCase>& cases);

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

/// Along each axis, both ways.
inline const std::array<glm::dvec3, 6> axisDirections = {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0),
                                                         glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0),
                                                         glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)};

/// The largest difference of any channel, of any pixel; a value that is not a number is infinitely far.
double largestDifference(const glm::dvec4& a, const glm::dvec4& b);
double largestDifference(const DrawnPicture& a, const DrawnPicture& b);

/// As largestDifference, of the pixels more than two voxels beside one. The pictures have a pixel per voxel
/// along y: pixel (x, y) sees the column i = x, k = height - 1 - y.
double differenceBeside(const glm::ivec3& voxel, const DrawnPicture& a, const DrawnPicture& b);

/// The largest difference of any pixel's alpha from `expected`.
double largestAlphaError(const DrawnPicture& picture, double expected);

/// How many pixels are unsound: a channel that is not finite or below 0, an alpha above 1, or a colour above
/// alpha by more than 1e-6 (colours are limited to 1 before compositing).
int unsoundPixels(const DrawnPicture& picture);

/// How many pixels show anything.
int visiblePixels(const DrawnPicture& picture);

/// A value that is not a number counts as infinitely large, so that no bound admits it.
double finiteOrInfinite(double figure);

/// A scene that shows a whole volume orthographically along `direction` (world), lit by the model, with steps
/// of half a voxel and no early termination; the function rises from nothing at `lowest` to 0.6 at `highest`.
Scene wholeVolume(std::shared_ptr<const Volume> volume, ShadingModel model, double lowest, double highest,
                  const glm::dvec3& direction = {0.0, 1.0, 0.0});

/// A volume of `edge`³ voxels of 1 mm that is smooth, has gradients in all directions and values 0..100.
std::shared_ptr<const Volume> smoothVolume(int edge, double scale = 1.0);

/// A finding of the ray caster with a decision about accuracy taken otherwise than the program takes it.
Finding takenOtherwise(const Workbench& bench, const Decisions& decisions, const std::string& what,
                       double bound, const std::string& reason,
                       const std::function<double(const Draw& draw)>& figure);

} // namespace limn
