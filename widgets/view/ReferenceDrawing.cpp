// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/ReferenceDrawing.h"

#include "scene/Error.h"
#include "widgets/view/PictureBytes.h"

#include <algorithm>

namespace limn {
namespace {

constexpr int widths[] = {80, 240}; // pixels, one after the other

glm::ivec2 sizeOfWidth(const glm::ivec2& size, int width) {
  const int narrow = std::clamp(width, 1, std::max(1, size.x));
  return {narrow, std::max(1, narrow * size.y / std::max(1, size.x))};
}

} // namespace

ReferenceDrawing::ReferenceDrawing(QObject* parent) : QObject(parent) {
  m_pool.setMaxThreadCount(1);
}

ReferenceDrawing::~ReferenceDrawing() {
  stop();
  m_pool.waitForDone();
}

void ReferenceDrawing::stop() {
  ++m_order;
  m_pool.clear();
}

void ReferenceDrawing::draw(const std::vector<Scene>& scenes, const glm::ivec2& size) {
  stop();
  const int order = m_order;
  m_pool.start([this, scenes, size, order] { drawAll(scenes, size, order); });
}

// Runs on the pool's thread; what it tells arrives on the owner's.
void ReferenceDrawing::drawAll(const std::vector<Scene>& scenes, const glm::ivec2& size, int order) {
  const auto isCancelled = [this, order] { return m_order != order; };
  try {
    for (const int width : widths) {
      std::vector<QImage> pictures;
      for (const Scene& scene : scenes)
        pictures.push_back(
            overBackground(m_renderer(scene, sizeOfWidth(size, width), isCancelled), scene.image.background));
      const bool isComplete = width == widths[std::size(widths) - 1];
      QMetaObject::invokeMethod(this, [this, pictures, isComplete, order] {
        if (m_order == order)
          emit drawn(pictures, isComplete);
      });
    }
  } catch (const Cancelled&) {
    return;
  } catch (const std::exception& error) {
    const QString sentence = QString::fromStdString(error.what());
    QMetaObject::invokeMethod(this, [this, sentence, order] {
      if (m_order == order)
        emit failed(sentence);
    });
  }
}

} // namespace limn
