// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QImage>
#include <QObject>

#include <atomic>
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
/// they need. Lives on a thread of its own; all but `end` is called there.
class ThumbnailWorker : public QObject {
  Q_OBJECT

public:
  ThumbnailWorker();
  ~ThumbnailWorker() override;

  /// From any thread: what belongs to orders before this one ends within some milliseconds.
  void end(int order) { m_order = order; }

  /// Draws an order that has not ended; its pictures have `size` pixels.
  void draw(int order, const std::vector<Thumbnail>& wanted, const QSize& size);

  /// Lets go of everything that was made of a volume.
  void forget();

signals:
  /// `showsNothing`: nothing of the volume is visible in it.
  void drawn(int order, const QString& name, const QImage& picture, bool showsNothing);
  void finished(int order); ///< all that could be drawn was

private:
  Scene reducedScene(const Scene& scene, const std::function<bool()>& isEnded);

  std::atomic<int> m_order = 0;
  std::unique_ptr<DrawingEngine> m_engine;
  std::weak_ptr<const Volume> m_whole; ///< what `m_volume` was made of
  std::shared_ptr<const Volume> m_volume;
  Region m_wholeKeep;
  Region m_keep;
};

} // namespace limn
