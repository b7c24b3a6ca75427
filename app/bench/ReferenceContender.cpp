// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/Contender.h"
#include "io/ImageFile.h"
#include "reference/ReferenceIntegrator.h"

namespace limn {
namespace {

class ReferenceContender : public Contender {
public:
  explicit ReferenceContender(int threads) : m_threads(threads) {}

  std::string program() const override { return "limn-reference"; }
  std::string renderer() const override { return "double precision"; }

  FrameCost drawFirst(const Scene& scene) override {
    forgetPeak();
    m_residentBefore = residentMb();
    return draw(scene);
  }

  FrameCost draw(const Scene& scene) override {
    m_background = scene.image.background;
    return costOf([&] {
      m_picture = toImage(renderReference(scene, {scene.image.width, scene.image.height}, m_threads));
    });
  }

  double peakMb() override { return peakResidentMb() - m_residentBefore; }

  void save(const std::filesystem::path& path) override { writeImage(path, m_picture, m_background, {}); }

private:
  int m_threads;
  Image m_picture;
  glm::dvec3 m_background{0.0};
  double m_residentBefore = 0.0;
};

} // namespace

std::unique_ptr<Contender> referenceContender(int threads) {
  return std::make_unique<ReferenceContender>(threads);
}

} // namespace limn
