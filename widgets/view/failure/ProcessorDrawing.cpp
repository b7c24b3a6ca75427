// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/failure/ProcessorDrawing.h"

#include "engine/DrawingEngine.h"
#include "scene/basics/Error.h"
#include "widgets/view/pictures/FinishedPicture.h"

#include <algorithm>

namespace limn {
namespace {

constexpr int firstWidth = 240; // pixels

glm::ivec2 sizeOfWidth(const glm::ivec2& size, int width) {
  const int narrow = std::clamp(width, 1, std::max(1, size.x));
  return {narrow, std::max(1, narrow * size.y / std::max(1, size.x))};
}

} // namespace

ProcessorDrawing::ProcessorDrawing(MakeEngine makeEngine, QObject* parent)
    : QObject(parent), m_makeEngine(std::move(makeEngine)) {
  // The engine stays where it was made.
  m_pool.setMaxThreadCount(1);
  m_pool.setExpiryTimeout(-1);
}

ProcessorDrawing::~ProcessorDrawing() {
  stop();
  m_pool.waitForDone();
}

void ProcessorDrawing::stop() {
  ++m_order;
  m_pool.clear();
}

void ProcessorDrawing::draw(const std::vector<Scene>& scenes, const glm::ivec2& size) {
  stop();
  const int order = m_order;
  m_pool.start([this, scenes, size, order] { drawAll(scenes, size, order); });
}

// Runs on the pool's thread; what it tells arrives on the owner's.
void ProcessorDrawing::drawAll(const std::vector<Scene>& scenes, const glm::ivec2& size, int order) {
  const auto isCancelled = [this, order] { return m_order != order; };
  try {
    if (!m_engine)
      m_engine = m_makeEngine();
    const auto picture = [&](const Scene& scene, const glm::ivec2& pixels) {
      return overBackground(m_engine->draw(scene, pixels, {{0, 0}, pixels}, isCancelled).value(),
                            scene.image.background);
    };
    for (const int width : {firstWidth, size.x}) {
      std::vector<QImage> pictures;
      for (const Scene& scene : scenes)
        pictures.push_back(picture(scene, sizeOfWidth(size, width)));
      const bool isComplete = width >= size.x;
      QMetaObject::invokeMethod(this, [this, pictures, isComplete, order] {
        if (m_order == order)
          emit drawn(pictures, isComplete);
      });
      if (isComplete)
        return;
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
