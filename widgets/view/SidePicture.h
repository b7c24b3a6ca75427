// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/InteractionQuality.h"
#include "widgets/view/PicturePresenter.h"
#include "widgets/view/PictureTarget.h"
#include "widgets/view/TileSchedule.h"

#include <QImage>

#include <optional>

namespace limn {

/// One picture of the view on its way from coarse to full quality: a coarse picture at once, then strips of the
/// full one above it, at the end the full one as 8 bits. Needs the same OpenGL context current for every call
/// that draws and for its end.
class SidePicture {
public:
  /// Asks for another picture; what was being drawn is dropped, what is shown stays until something newer is.
  void want(const Scene& scene, const glm::ivec2& size);

  /// Draws the coarse picture (level 0: the full one) and returns the time, ms.
  double drawCoarsely(RayCaster& caster, int level);

  /// Draws the next strip of the full picture.
  void drawStrip(RayCaster& caster);
  const TileSchedule& schedule() const { return m_schedule; }

  /// Reads the full picture back and makes it 8 bits on the processor, so that what is shown is rounded as a
  /// file is, whatever the driver. Only while complete.
  void finish();
  bool finished() const { return m_finished; }

  /// Shows `part` of the picture at `place`.
  void show(const PicturePresenter& presenter, PicturePresenter::Placement placement) const;

  /// The textures: rows [0, rowsDone) of the full picture, the rest of the coarse one; 0 where there is none.
  int rowsDone() const { return m_finished ? m_size.y : m_schedule.rowsDone(); }
  unsigned fullTexture() const { return m_finished ? m_bytesTexture.texture() : m_full.texture(); }
  unsigned coarseTexture() const { return m_coarse.texture(); }

  const Scene& scene() const { return m_scene; }
  double shownStepVoxels() const; ///< of the coarsest part shown
  std::optional<double> completeMs() const { return m_completeMs; }
  const std::optional<Image>& image() const { return m_image; } ///< while finished
  const QImage& bytes() const { return m_bytes; }               ///< while finished

private:
  Scene m_scene;
  glm::ivec2 m_size{0};
  TileSchedule m_schedule;
  double m_coarseFactor = 1.0;
  std::optional<double> m_completeMs;
  bool m_finished = false;
  PictureTarget m_coarse, m_full;
  ByteTexture m_bytesTexture;
  std::optional<Image> m_image;
  QImage m_bytes;
};

} // namespace limn
