// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "scene/light/Gradient.h"
#include "widgets/view/pictures/PictureScreen.h"
#include "widgets/view/pictures/PictureState.h"
#include "widgets/view/pictures/TileSchedule.h"

#include <optional>

namespace limn {

class DrawingEngine;

/// One picture of the view on its way from coarse to full quality: a coarse picture at once; above it strips
/// of a middling one, where the coarse one is very coarse; then strips of the full one; at the end the full
/// one as 8 bits. Of physical light the middling one gets twice and twice as many paths for some seconds, and
/// the full one as many from its beginning, so that it is never noisier than what it replaces. On request it
/// is then replaced, again strip by strip, by pictures of smaller steps. Lives where its screen does.
class SidePicture {
public:
  explicit SidePicture(PictureScreen& screen);

  /// Asks for another picture; what was being drawn is dropped, what is shown stays until something newer is.
  void want(const Scene& scene, const glm::ivec2& size);

  /// The finest level at which the coarse picture is drawn, however fast that is: 0 unless light makes the
  /// full one take minutes.
  int finestLevel(DrawingEngine& engine) const;

  /// Draws the coarse picture, as far as its columns will be seen (level 0: the full one, all of it), and
  /// returns the time, ms. Of physical light that was followed before and is only shown otherwise, it is
  /// what was found, at no price (0 ms).
  double drawCoarsely(DrawingEngine& engine, int level, const Columns& seen);

  /// Draws the next strip; only while not complete.
  void drawStrip(DrawingEngine& engine);
  bool complete() const { return m_pass == 0 && m_schedule.complete(); }
  /// The drawing time in which the middling picture of physical light is bettered, ms, and the most paths
  /// that it gets: on two cores both are reached at about once in 512² pixels.
  static constexpr double middleMs = 2500.0;
  static constexpr int mostMiddlePaths = 16;
  double fraction() const; ///< of the work from the coarse picture to the full one, 0..1
  double predictedMs() const { return m_schedule.predictedMs(); } ///< of the next strip

  /// Reads the full picture back and makes it 8 bits on the processor, so that what is shown is rounded as a
  /// file is, whatever the driver. Only while complete.
  void finish();
  bool finished() const { return m_finished; }

  /// Whether the coarse picture, or part of the full one, was drawn while its light was being found.
  bool coarseLacksLight() const { return m_coarseLacksLight; }
  bool lacksLight() const { return m_lacksLight; }
  /// The scene of the coarse picture, all of its voxels.
  Scene coarseScene() const { return withQualityLevel(m_scene, m_coarseQuality); }

  /// Begins to draw the finished picture anew with a better quality, which is expected to take `expectedMs`;
  /// until it is adopted, everything told of the finished picture stays.
  void beginFiner(const Quality& quality, double expectedMs);
  bool isFiner() const { return m_finer.has_value(); } ///< begun and not adopted yet
  void leaveFiner() { m_finer.reset(); }
  /// Lets the driver compile what a step needs; false where it has. Only while a finer picture is begun.
  bool prepareFiner(DrawingEngine& engine, double stepVoxels);
  void drawFinerStrip(DrawingEngine& engine);
  const TileSchedule& finerSchedule() const { return m_finer->schedule; }
  Scene finerScene() const; ///< with the quality begun
  /// Its picture, once its schedule is complete; waits for the drawing to end.
  Image readFiner() const { return m_full->read(); }
  void adoptFiner(FinishedPicture picture);
  /// Shows another in place of the finished picture, of the same quality.
  void replace(FinishedPicture picture) { adopt(std::move(picture), m_finishedQuality); }

  /// Shows `part` of the picture at `place`.
  void show(PictureScreen& screen, const PixelRect& place, const PixelRect& part) const;

  /// What to show: the finer pixels for the rows [0, rowsDone) of the full size, the coarser ones, where
  /// there are some, below.
  int rowsDone() const;
  const ShownPixels& finerPixels() const;
  const ShownPixels& coarserPixels() const;
  bool hasCoarser() const { return m_finer || !m_coarse->isEmpty(); }

  /// Whether the coarse picture was drawn from fewer voxels.
  bool hadStandIn() const { return m_standIn.has_value(); }

  const Scene& scene() const { return m_scene; }
  const glm::ivec2& size() const { return m_size; }
  /// Of the coarsest part shown: the scene with the quality that it was drawn with, its share of width and
  /// height (0..1), what drawing it took.
  Scene shownScene() const;
  /// Where the coarsest part shown is drawn from fewer voxels: how far they lie from the whole volume's.
  std::optional<Coarseness> shownCoarseness() const;
  double shownImageScale() const { return complete() ? 1.0 : m_coarseQuality.imageScale; }
  double shownMs() const { return complete() ? m_completeMs.value_or(0.0) : m_coarseMs; }
  std::optional<double> completeMs() const { return m_completeMs; }
  /// Of physical light, how many paths each pixel of what is shown has at least.
  int shownPaths() const { return m_finished ? m_finishedQuality.paths.value_or(1) : m_coarsePaths; }
  /// What following one more of each pixel took last, ms of drawing; absent before.
  std::optional<double> msPerPath() const { return m_msPerPath; }
  const GradientScale& gradientScale() const { return m_gradientScale; }
  const FinishedPicture& picture() const { return m_picture; }         ///< empty unless finished
  const Quality& finishedQuality() const { return m_finishedQuality; } ///< that it was drawn with
  std::optional<double> contrast() const;                              ///< while finished

private:
  // A picture of smaller steps that replaces the finished one.
  struct Finer {
    Quality quality;
    TileSchedule schedule;
  };
  void adopt(FinishedPicture picture, const Quality& quality);
  Scene passScene(DrawingEngine& engine, const QualityLevel& quality, const glm::ivec2& size);
  Scene fullScene(DrawingEngine& engine);
  void drawFollowed(DrawingEngine& engine);
  void betterMiddle();

  Scene m_scene;
  glm::ivec2 m_size{0};
  int m_pass = 0; ///< the quality level that is being drawn in strips
  TileSchedule m_schedule;
  bool m_hasMiddlePass = false;
  // Of physical light.
  int m_middlePaths = 1;        ///< of the middling picture that is drawn
  double m_spentMs = 0.0;       ///< for middling ones
  int m_coarsePaths = 1;        ///< of the coarse picture
  QualityLevel m_coarseQuality; ///< of the coarse picture
  std::optional<StandIn>
      m_standIn; ///< that it is drawn from, where its scene's volume does not lie in memory
  double m_coarseMs = 0.0;
  GradientScale m_gradientScale;
  std::optional<double> m_completeMs;
  bool m_finished = false;
  bool m_coarseLacksLight = false, m_lacksLight = false;
  std::unique_ptr<PictureSheet> m_coarse, m_middle, m_full;
  std::unique_ptr<FinishedSheet> m_finishedSheet;
  double m_stripMs;
  FinishedPicture m_picture;
  Quality m_finishedQuality;
  std::vector<double> m_finishedRowMs; ///< what each of its rows took
  std::optional<Finer> m_finer;
  std::optional<int> m_paths; ///< of the full picture, where light is physical; absent before it is begun
  int m_followedBefore = 0;   ///< of those
  std::optional<double> m_msPerPath;
};

} // namespace limn
