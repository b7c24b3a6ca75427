// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/ProcessorDrawing.h"
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "scene/basics/Error.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/Waiting.h"

#include <QThread>

#include <gtest/gtest.h>

#include <atomic>
#include <semaphore>
#include <thread>

// Pictures from a thread of their own, without a window and without OpenGL.

namespace limn {
namespace {

constexpr glm::ivec2 pictureSize{160, 120};

// Holds the first piece that is finer than the picture at rest until it is cancelled. Pieces of that picture
// are never held: where the machine is quick, they are what is seen while something moves, which nothing
// cancels.
class HoldingEngine final : public DrawingEngine {
public:
  HoldingEngine(std::atomic<bool>& isHolding, double restingStep)
      : m_isHolding(isHolding), m_restingStep(restingStep) {}

  double makeReady(const Scene& scene, const Effort& effort) override {
    return m_engine->makeReady(scene, effort);
  }
  std::optional<Image> draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                            const IsCancelled& isCancelled) override {
    const Quality& quality = scene.quality;
    const bool isFiner = quality.toleranceLevels || quality.stepVoxels < m_restingStep;
    if (isFiner && isCancelled && !m_isHolding.exchange(true)) {
      while (!isCancelled())
        std::this_thread::yield();
      throw Cancelled();
    }
    return m_engine->draw(scene, size, tile, isCancelled);
  }
  Image drawUnlimited(const Scene& scene, const glm::ivec2& size) override {
    return m_engine->drawUnlimited(scene, size);
  }
  bool prepare(const Scene& scene, const glm::ivec2& size) override { return m_engine->prepare(scene, size); }
  std::unique_ptr<EffectMeasurement> measureEffects(const Scene& scene, const glm::ivec2& size) override {
    return m_engine->measureEffects(scene, size);
  }
  DrawingFacts facts(const Scene& scene) override { return m_engine->facts(scene); }
  GradientScale gradientScale() const override { return m_engine->gradientScale(); }
  int compiledPrograms() const override { return m_engine->compiledPrograms(); }
  double memoryMb() const override { return m_engine->memoryMb(); }
  std::string name() const override { return m_engine->name(); }
  Message limitation() const override { return m_engine->limitation(); }

private:
  std::atomic<bool>& m_isHolding;
  double m_restingStep;
  std::unique_ptr<DrawingEngine> m_engine = makeCpuEngine(2);
};

class Worker : public testing::Test {
protected:
  Worker() {
    QObject::connect(
        worker, &PictureWorker::delivered, &receiver,
        [this] {
          if (std::optional<PictureDelivery> delivery = worker->take())
            deliveries.push_back(std::move(*delivery));
        },
        Qt::QueuedConnection);
    QObject::connect(&thread, &QThread::finished, worker, &QObject::deleteLater);
    worker->moveToThread(&thread);
    thread.start();
  }
  ~Worker() override {
    worker->interrupt();
    thread.quit();
    thread.wait();
  }

  static Scene turned(double angle) {
    static const std::shared_ptr<const Volume> volume = phantomVolume({4.0, 0.0, 1});
    Scene scene = headScene(volume, ShadingModel::classic);
    scene.camera = orbited(scene.camera, angle, 0.0);
    return scene;
  }
  static PictureOrder orderOf(const Scene& scene) {
    PictureOrder order;
    order.isSeen = true;
    order.scenes = {scene};
    order.size = order.screen = pictureSize;
    order.places = {{{0, 0}, pictureSize}};
    order.lastName = QStringLiteral("Classic");
    return order;
  }
  void ask(int number, const Scene& scene) { worker->ask(orderOf(scene), number); }
  void rest(int number) { worker->ask({}, number); }
  [[nodiscard]] bool isComplete(int number) {
    return test::waitUntil([&] {
      return !deliveries.empty() && deliveries.back().number == number && !deliveries.back().resting.empty();
    });
  }

  bool refuses = false; ///< to make an engine
  bool holds = false;   ///< makes one that waits
  std::atomic<bool> isHolding = false;
  PictureWorker* worker = new PictureWorker([this] {
    if (std::exchange(refuses, false))
      throw Error(Error::Kind::input, "There is no engine.");
    return holds ? std::make_unique<HoldingEngine>(isHolding, turned(0.0).quality.stepVoxels)
                 : makeCpuEngine(2);
  });
  QThread thread;
  QObject receiver;
  std::vector<PictureDelivery> deliveries;
};

TEST_F(Worker, deliversCoarsePicturesAndThenTheWholeOne) {
  ask(1, turned(0.0));
  ASSERT_TRUE(isComplete(1));
  EXPECT_LT(deliveries.front().news.state.sides[0].imageScale, 1.0);
  EXPECT_TRUE(deliveries.front().resting.empty());
  const PictureDelivery& last = deliveries.back();
  EXPECT_EQ(*last.resting[0].image, CpuRenderer(1).render(turned(0.0), pictureSize));
  EXPECT_EQ(last.frame.convertToFormat(QImage::Format_RGBA8888), last.resting[0].bytes);
  EXPECT_EQ(last.camera, turned(0.0).camera);
}

TEST_F(Worker, ofManyOrdersTheLastOneIsCompleteAndNoneIsMixedWithAnother) {
  constexpr int orders = 60;
  for (int i = 1; i <= orders; ++i) {
    ask(i, turned(0.02 * i));
    if (i % 6 == 0) { // let some be drawn
      ASSERT_TRUE(test::waitUntil([&, before = deliveries.size()] { return deliveries.size() > before; }));
    }
  }
  ASSERT_TRUE(isComplete(orders));
  EXPECT_EQ(*deliveries.back().resting[0].image, CpuRenderer(1).render(turned(0.02 * orders), pictureSize));
  for (std::size_t i = 1; i < deliveries.size(); ++i)
    EXPECT_LE(deliveries[i - 1].number, deliveries[i].number);
}

TEST_F(Worker, theSameNumberOnlyPutsThePicturesTogetherOtherwise) {
  ask(1, turned(0.0));
  ASSERT_TRUE(isComplete(1));
  const std::size_t before = deliveries.size();
  PictureOrder wider = orderOf(turned(0.0));
  wider.places = {{{40, 0}, pictureSize}};
  wider.screen = {200, 120};
  worker->ask(wider, 1);
  ASSERT_TRUE(test::waitUntil([&] { return deliveries.back().frame.width() == 200; }));
  for (std::size_t i = before; i < deliveries.size(); ++i)
    EXPECT_FALSE(deliveries[i].resting.empty()) << "what is complete stays so";
}

// On a busy machine the thread may see an order, a rest and another order at once.
TEST_F(Worker, aRestEndsWhatWasAskedForBeforeItAndNothingAfter) {
  const auto whileItSleeps = [this](const auto& work) {
    std::binary_semaphore isAwake{0};
    QMetaObject::invokeMethod(
        worker, [&isAwake] { isAwake.acquire(); }, Qt::QueuedConnection);
    work();
    isAwake.release();
    QMetaObject::invokeMethod(
        worker, [] {}, Qt::BlockingQueuedConnection); // and all before it is done
  };
  whileItSleeps([this] {
    ask(1, turned(0.0));
    rest(1);
  });
  EXPECT_FALSE(worker->take()) << "the first order was dropped";
  whileItSleeps([this] {
    ask(2, turned(0.1));
    rest(2);
    ask(3, turned(0.2));
  });
  EXPECT_TRUE(isComplete(3));
}

TEST_F(Worker, afterAFailureTheNextOrderIsDrawn) {
  refuses = true;
  ask(1, turned(0.0));
  ASSERT_TRUE(
      test::waitUntil([this] { return !deliveries.empty() && !deliveries.back().news.failure.isEmpty(); }));
  EXPECT_EQ(deliveries.back().news.failure, QStringLiteral("There is no engine."));
  ask(2, turned(0.1));
  EXPECT_TRUE(isComplete(2));
}

// A piece may take very long, as of light that travels.
TEST_F(Worker, whatRefinesGivesWayToAMeasurementAndGoesOnAfterIt) {
  holds = true;
  ask(1, turned(0.0));
  ASSERT_TRUE(test::waitUntil([&] { return isHolding && !deliveries.empty(); }));
  worker->measureEffects(true);
  ASSERT_TRUE(test::waitUntil([&] { return !deliveries.back().news.times.costs.empty(); }));
  EXPECT_EQ(deliveries.back().measurements, 1);
  EXPECT_TRUE(test::waitUntil([&] { return deliveries.back().news.state.refinementEnd.has_value(); }));
}

// The destructor above waits for the thread.
TEST_F(Worker, endsInTheMiddleOfAPicture) {
  Scene scene = turned(0.0);
  scene.quality.stepVoxels = 1.0 / 64.0;
  ask(1, scene);
  EXPECT_TRUE(test::waitUntil([this] { return !deliveries.empty(); }));
}

} // namespace
} // namespace limn
