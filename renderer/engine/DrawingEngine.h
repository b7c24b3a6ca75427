// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PathFigures.h"
#include "engine/PixelRect.h"
#include "scene/Scene.h"
#include "scene/basics/Effort.h"
#include "scene/basics/Image.h"
#include "scene/effects/EffectRows.h"
#include "scene/light/Gradient.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// How a volume in fewer voxels stands for the whole one.
struct Coarseness {
  int reduction = 1;         ///< so many voxels of the whole one along each axis make one
  double largestError = 0.0; ///< values differ nowhere by more than this share of the whole one's range
  bool operator==(const Coarseness&) const = default;
};

/// A scene that is drawn in place of another while something moves.
struct StandIn {
  Scene scene; ///< the same but for the volume, what is kept of it, and that steps are in its own voxels
  Coarseness coarseness;
};

/// What an engine can tell of a scene before it draws it.
struct DrawingFacts {
  EffectPlan plan;            ///< what the scene calls for, and why
  double steepestPerMm = 0.0; ///< what its field commonly changes by at most, value/mm (scene/light/Gradient)
  bool takesAllSamples = true; ///< false: rays end at a limit, past which a smaller step changes nothing
  bool isReady = true;         ///< nothing need be compiled before it is drawn
  bool goesByCells = false; ///< a tolerance is kept cell by cell (scene/steps/CellRule), not in local steps
  bool findsLightOfSamples = false; ///< light that travels may be found for each sample, to compare with
  int filterBits = mostFilterBits;  ///< of the weights by which its filter mixes voxels (SceneFacts)
};

/// What came out of measuring the effects of a picture so far.
struct EffectFigures {
  bool isComplete = false;
  double fraction = 0.0;                        ///< of the frames, 0..1
  std::vector<std::optional<EffectCost>> costs; ///< one per row of the plan, absent where it is off; empty
                                                ///< before all is measured
  double wholeMs = 0.0;                         ///< of the picture with all its effects
  std::string method;                           ///< how the time was measured, a phrase
  std::vector<std::optional<EffectCost>> wouldCosts{}; ///< the same of what is off, where it could be on
  bool isWaiting = false;                              ///< for light that is found beside
};

/// Measures what each effect of a picture costs, a frame at a time. Ends before its engine does.
class EffectMeasurement {
public:
  virtual ~EffectMeasurement() = default;

  /// Draws the next frame, in OpenGL into the framebuffer bound; only while not complete.
  virtual void step() = 0;
  virtual EffectFigures figures() const = 0;
};

/// What draws pictures of scenes (README.md). Keeps what it made of one scene for the next. All calls, its
/// end included, come from one thread, on which the OpenGL context that it was made with, if any, is current.
class DrawingEngine {
public:
  /// Asked now and then while a tile is drawn; true ends the drawing with Cancelled. May be empty.
  using IsCancelled = std::function<bool()>;

  virtual ~DrawingEngine() = default;

  /// Draws the pixels of `tile` of a picture of `size` pixels: premultiplied RGBA without background; pixels
  /// outside the volume become zero. Any tiling gives the same picture bit for bit. An engine that draws with
  /// OpenGL draws into the framebuffer bound, whose lower left corner is the picture's, and returns nothing;
  /// one that computes in memory returns the tile. Throws Error.
  virtual std::optional<Image> draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                                    const IsCancelled& isCancelled) = 0;

  /// Gets ready for the scene's volume and returns the share that is done, 1 once a picture need not wait for
  /// it. An engine whose thread others need does a piece of some ten ms in each call; one that has a thread
  /// to itself does all in one, tells `effort` how far it is and asks it whether to end, with Cancelled. A
  /// picture drawn earlier waits for the rest. Throws Error.
  virtual double makeReady(const Scene& scene, const Effort& effort) = 0;

  /// What to draw in its place, in `size` pixels, while something moves: where the scene's volume does not
  /// lie in memory, one of fewer voxels. Absent where the scene itself is drawn, or the engine is not ready
  /// for it.
  virtual std::optional<StandIn> standInFor(const Scene&, const glm::ivec2& /*size*/) { return std::nullopt; }

  /// Whether light that travels in a scene is still being found: what is drawn meanwhile shows what is known
  /// of it, perhaps of the scene before. An engine that finds it while it draws is never asked twice.
  virtual bool isFindingLight(const Scene&) { return false; }

  /// The whole picture whose light terms are not limited (DEFINITION section 4), to see how far they
  /// overflow.
  virtual Image drawUnlimited(const Scene& scene, const glm::ivec2& size) = 0;

  /// Does one piece of what the scene and those near it may soon need; for when nobody waits. May draw into
  /// the middle of the framebuffer bound, of `size` pixels. False when nothing is left to do.
  virtual bool prepare(const Scene& scene, const glm::ivec2& size) = 0;

  /// Begins to measure what the effects of a picture of `size` pixels cost; null where effects cannot be left
  /// out.
  virtual std::unique_ptr<EffectMeasurement> measureEffects(const Scene& scene, const glm::ivec2& size) = 0;

  virtual DrawingFacts facts(const Scene& scene) = 0;

  /// How far the paths of a picture of physical light are (DEFINITION section 12); absent where it is not
  /// one, or was not drawn lately.
  virtual std::optional<PathFigures> pathFigures(const Scene&, const glm::ivec2& /*size*/) {
    return std::nullopt;
  }

  /// How many paths of each pixel a picture of physical light goes on from, because they were followed
  /// before, however it was exposed; 0 where it begins. With none more (Quality::paths 0) it is drawn at
  /// once.
  virtual int followedPaths(const Scene&, const glm::ivec2& /*size*/) { return 0; }

  /// The gradient moduli that the scene drawn last was lit with; meaningful where its lighting reads them.
  virtual GradientScale gradientScale() const = 0;

  /// How many programs were compiled so far: editing a control point must not raise it.
  virtual int compiledPrograms() const = 0;

  /// What the volume takes beside the process's own copy, MB (10⁶ bytes).
  virtual double memoryMb() const = 0;

  /// Who draws, for people: the driver's name of the card, or of the method.
  virtual std::string name() const = 0;

  /// A sentence each where less than the whole volume, or fewer samples than asked for, are drawn of the
  /// scene asked about last; empty otherwise.
  virtual Message limitation() const = 0;
};

using MakeEngine = std::function<std::unique_ptr<DrawingEngine>()>;

/// Draws, in double precision, those pixels of a picture of `size` that are wanted (not 0) and leaves the
/// others as they are: premultiplied RGBA without background, rows from the top.
using DrawPrecisely =
    std::function<void(const Scene& scene, const glm::ivec2& size, const std::vector<std::uint8_t>& wanted,
                       std::vector<glm::dvec4>& pixels)>;

/// Makes what draws precisely beside everything else; it ends with Cancelled where it is told to.
using MakePrecise = std::function<DrawPrecisely(std::function<bool()> isCancelled)>;

/// What a view draws with, chosen by the program.
struct DrawingEngines {
  MakeEngine driver;    ///< draws in strips while the graphics driver works; called with its context current
  MakeEngine processor; ///< draws in memory when the driver has failed; may be empty: then a sentence says so
  MakePrecise precisely; ///< says of pictures at rest how exact they are; may be empty
};

} // namespace limn
