// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/OnDisk.h"
#include "app/lab/bench/Contender.h"
#include "gl/PictureTarget.h"
#include "io/ImageFile.h"

#include <epoxy/gl.h>

#include <optional>
#include <sstream>

namespace limn {
namespace {

class GlContender : public Contender {
public:
  GlContender(std::shared_ptr<HeadlessContext> context, RayCaster::Programs programs)
      : m_context(std::move(context)), m_programs(programs) {}

  std::string program() const override {
    return m_programs == RayCaster::Programs::specialised ? "limn-gl" : "limn-gl-all";
  }
  std::string renderer() const override { return rendererName(); }

  std::string effects(const Scene& scene) override {
    if (m_programs == RayCaster::Programs::allEffects)
      return "every effect with a neutral value";
    std::ostringstream names;
    const EffectSet needed = m_caster->plan(scene).effects;
    for (int i = 0; i < effectCount; ++i)
      if (needed.has(static_cast<Effect>(i)))
        names << describe(static_cast<Effect>(i)).name << ' ';
    return names.str();
  }

  FrameCost drawFirst(const Scene& scene) override {
    requireOpenGlMayCopy(scene);
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
        m_caster.emplace(RayCaster::EmptySpace::skipped, m_programs);
      m_caster->draw(scene, size, {{0, 0}, size});
      glFinish();
    });
  }

  double peakMb() override { return peakResidentMb() - m_residentBefore; }

  void save(const std::filesystem::path& path) override {
    writeImage(path, m_target->read(), m_background, {});
  }

private:
  std::shared_ptr<HeadlessContext> m_context;
  RayCaster::Programs m_programs;
  std::optional<RayCaster> m_caster;
  std::optional<PictureTarget> m_target;
  glm::dvec3 m_background{0.0};
  double m_residentBefore = 0.0;
};

} // namespace

std::unique_ptr<Contender> glContender(std::shared_ptr<HeadlessContext> context,
                                       RayCaster::Programs programs) {
  return std::make_unique<GlContender>(std::move(context), programs);
}

} // namespace limn
