// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Workbench.h"

#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"

#include <iterator>

namespace limn {
namespace {

constexpr int smallestPictureShown = 16;
constexpr std::size_t mostPicturesShown = 2;

DrawnPicture drawnPicture(const Image& image) {
  return {image.size, {image.pixels.begin(), image.pixels.end()}};
}

Image imageOf(const DrawnPicture& picture) {
  Image image(picture.size);
  std::copy(picture.pixels.begin(), picture.pixels.end(), image.pixels.begin());
  return image;
}

double boundOf(const Bounds& bounds, Engine engine) {
  switch (engine) {
  case Engine::reference:
    return bounds.reference;
  case Engine::gl:
  case Engine::cpu:
    return bounds.gl;
  case Engine::slices:
    return bounds.slices;
  }
  return 0.0;
}

} // namespace

std::string nameOf(Engine engine) {
  const char* names[] = {"reference", "gl", "slices", "cpu"};
  return names[static_cast<int>(engine)];
}

DrawnPicture Workbench::draw(Engine engine, const Scene& scene, const glm::ivec2& size) {
  switch (engine) {
  case Engine::reference:
    return {size, renderReference(scene, size).pixels};
  case Engine::gl:
    return drawnPicture(rays().render(scene, size));
  case Engine::slices:
    return drawnPicture(slices().render(scene, size));
  case Engine::cpu:
    return drawnPicture(processor().render(scene, size));
  }
  return {};
}

void Workbench::requireOpenGl() const {
  if (!hasOpenGl())
    throw Error(Error::Kind::usage, m_withoutOpenGl);
}

RayCaster& Workbench::rays() {
  requireOpenGl();
  if (!m_rays)
    m_rays.emplace();
  return *m_rays;
}

SliceRenderer& Workbench::slices() {
  requireOpenGl();
  if (!m_slices)
    m_slices.emplace();
  return *m_slices;
}

CpuRenderer& Workbench::processor() {
  if (!m_processor)
    m_processor.emplace();
  return *m_processor;
}

std::vector<Finding> inEngines(Workbench& bench, const std::vector<Engine>& engines, const std::string& what,
                               const Bounds& bounds, const std::string& reason,
                               const std::function<double(const Draw& draw)>& figure) {
  std::vector<Finding> findings;
  for (const Engine engine : engines) {
    std::vector<Image> pictures;
    const Draw draw = [&](const Scene& scene, const glm::ivec2& size) {
      DrawnPicture drawn = bench.draw(engine, scene, size);
      if (pictures.size() < mostPicturesShown && std::min(size.x, size.y) >= smallestPictureShown)
        pictures.push_back(imageOf(drawn));
      return drawn;
    };
    try {
      findings.push_back(atMost(nameOf(engine), what, figure(draw), boundOf(bounds, engine), reason));
      findings.back().pictures = std::move(pictures);
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::usage)
        throw;
      findings.push_back(notApplicable(nameOf(engine), what, error.what()));
    }
  }
  return findings;
}

std::vector<Finding> inEachEngine(Workbench& bench, const std::string& what, const Bounds& bounds,
                                  const std::string& reason,
                                  const std::function<double(const Draw& draw)>& figure) {
  return inEngines(bench, {Engine::reference, Engine::gl, Engine::slices, Engine::cpu}, what, bounds, reason,
                   figure);
}

Finding withOpenGl(const Workbench& bench, const std::string& engine, const std::string& what,
                   const std::function<Finding()>& measure) {
  try {
    bench.requireOpenGl();
  } catch (const Error& error) {
    return notApplicable(engine, what, error.what());
  }
  return measure();
}

std::vector<Finding>& operator+=(std::vector<Finding>& findings, std::vector<Finding> more) {
  findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  return findings;
}

} // namespace limn
