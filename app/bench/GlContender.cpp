// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/Contender.h"
#include "gl/HeadlessContext.h"
#include "io/ImageFile.h"
#include "raycaster/RayCaster.h"
#include "widgets/view/PictureTarget.h"

#include <epoxy/gl.h>

#include <optional>

namespace limn {
namespace {

class GlContender : public Contender {
public:
  std::string program() const override { return "limn-gl"; }
  std::string renderer() const override { return rendererName(); }

  FrameCost drawFirst(const Scene& scene) override {
    m_caster.reset();
    m_target.emplace();
    glFinish();
    forgetPeak();
    m_residentBefore = residentMb();
    return draw(scene);
  }

  FrameCost draw(const Scene& scene) override {
    m_background = scene.image.background;
    return costOf([&] {
      const glm::ivec2 size(scene.image.width, scene.image.height);
      m_target->resize(size);
      m_target->bind();
      if (!m_caster)
        m_caster.emplace();
      m_caster->draw(scene, size, {{0, 0}, size});
      glFinish();
    });
  }

  double peakMb() override { return peakResidentMb() - m_residentBefore; }

  void save(const std::filesystem::path& path) override {
    writeImage(path, m_target->read(), m_background, {});
  }

private:
  HeadlessContext m_context;
  std::optional<RayCaster> m_caster;
  std::optional<PictureTarget> m_target;
  glm::dvec3 m_background{0.0};
  double m_residentBefore = 0.0;
};

} // namespace

std::unique_ptr<Contender> glContender() {
  return std::make_unique<GlContender>();
}

} // namespace limn
