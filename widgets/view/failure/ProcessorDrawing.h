// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngines.h"
#include "scene/Scene.h"

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <vector>

namespace limn {

/// Draws the pictures of the view on another thread when the graphics driver does not: small ones at once,
/// larger ones behind them. Asked anew, it drops what it is at.
class ProcessorDrawing : public QObject {
  Q_OBJECT

public:
  /// `makeEngine` makes one that draws in memory; empty: nothing can be drawn.
  explicit ProcessorDrawing(MakeEngine makeEngine, QObject* parent = nullptr);
  ~ProcessorDrawing() override;

  bool canDraw() const { return m_makeEngine != nullptr; }

  /// Draws each scene in a picture at most 240 pixels wide, of the proportions of `size`, then in all its
  /// pixels.
  void draw(const std::vector<Scene>& scenes, const glm::ivec2& size);
  void stop();

signals:
  /// One picture for each scene, over its background. `isComplete`: no larger ones follow.
  void drawn(const std::vector<QImage>& pictures, bool isComplete);
  void failed(const QString& sentence);

private:
  void drawAll(const std::vector<Scene>& scenes, const glm::ivec2& size, int order);

  MakeEngine m_makeEngine;
  std::unique_ptr<DrawingEngine> m_engine; // on the pool's thread
  QThreadPool m_pool;
  std::atomic<int> m_order{0}; ///< the number of the last call of draw or stop
};

} // namespace limn
