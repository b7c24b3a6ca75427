// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Image.h"
#include "scene/Scene.h"

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <functional>
#include <vector>

namespace limn {

/// Draws a scene without a graphics card. `isCancelled`, asked now and then, ends it with Cancelled.
using DrawOnProcessor = std::function<Image(const Scene& scene, const glm::ivec2& size,
                                            const std::function<bool()>& isCancelled)>;

/// Draws the pictures of the view on another thread when the graphics driver does not: small ones at once,
/// larger ones behind them. Asked anew, it drops what it is at.
class ReferenceDrawing : public QObject {
  Q_OBJECT

public:
  explicit ReferenceDrawing(QObject* parent = nullptr);
  ~ReferenceDrawing() override;

  void setRenderer(DrawOnProcessor renderer) { m_renderer = std::move(renderer); }
  bool canDraw() const { return m_renderer != nullptr; }

  /// Draws each scene in a picture of the proportions of `size` and at most 240 pixels wide.
  void draw(const std::vector<Scene>& scenes, const glm::ivec2& size);
  void stop();

signals:
  /// One picture for each scene, over its background. `isComplete`: no larger ones follow.
  void drawn(const std::vector<QImage>& pictures, bool isComplete);
  void failed(const QString& sentence);

private:
  void drawAll(const std::vector<Scene>& scenes, const glm::ivec2& size, int order);

  DrawOnProcessor m_renderer;
  QThreadPool m_pool;
  std::atomic<int> m_order{0}; ///< the number of the last call of draw or stop
};

} // namespace limn
