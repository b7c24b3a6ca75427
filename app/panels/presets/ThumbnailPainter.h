// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QImage>

#include <functional>
#include <memory>
#include <vector>

namespace limn {

class DrawingEngine;

/// A small picture that is wanted.
struct Thumbnail {
  QString name; ///< of what it shows
  Scene scene;  ///< of the whole volume, with the camera that fits its shape
};

/// Draws small pictures on the processor, one after the other, of a copy of the volume that is no finer than
/// they need. For one thread at a time.
class ThumbnailPainter {
public:
  ThumbnailPainter();
  ~ThumbnailPainter();

  using IsEnded = std::function<bool()>;
  /// `showsNothing`: nothing of the volume is visible in the picture.
  using Drawn = std::function<void(const QString& name, const QImage& picture, bool showsNothing)>;

  /// Draws what is wanted, as far as it can be, with `size` pixels each; throws Cancelled some milliseconds
  /// after the word.
  void draw(const std::vector<Thumbnail>& wanted, const QSize& size, const IsEnded& isEnded,
            const Drawn& drawn);

private:
  Scene reducedScene(const Scene& scene, const IsEnded& isEnded);

  std::unique_ptr<DrawingEngine> m_engine;
  std::weak_ptr<const Volume> m_whole; ///< what `m_volume` was made of
  std::shared_ptr<const Volume> m_volume;
  Region m_wholeKeep;
  Region m_keep;
};

} // namespace limn
