// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Workbench.h"

#include "gl/GlObjects.h"
#include "gl/PictureTarget.h"
#include "glsl/PicturePresenter.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace limn {
namespace {

GlTexture textureOf(GLint format, const glm::ivec2& size, GLenum type, const void* pixels) {
  GlTexture texture;
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, format, size.x, size.y, 0, GL_RGBA, type, pixels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

// OpenGL's rows go upwards.
template <class Pixel>
std::vector<Pixel> upsideDown(const std::vector<Pixel>& pixels, const glm::ivec2& size) {
  std::vector<Pixel> flipped(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t row = i / size.x;
    flipped[(size.y - 1 - row) * size.x + i % size.x] = pixels[i];
  }
  return flipped;
}

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
  case Engine::rayCaster:
  case Engine::cpu:
    return bounds.gl;
  case Engine::slices:
  case Engine::slicesBackToFront:
    return bounds.slices;
  }
  return 0.0;
}

} // namespace

std::string verdictText(Verdict verdict) {
  const char* texts[] = {"pass", "fail", "n/a"};
  return texts[static_cast<int>(verdict)];
}

Finding atMost(std::string engine, std::string what, double figure, double bound, std::string reason) {
  return {std::move(engine), std::move(what), figure, bound, figure <= bound ? Verdict::pass : Verdict::fail,
          std::move(reason)};
}

Finding notApplicable(std::string engine, std::string what, std::string reason) {
  return {std::move(engine), std::move(what), 0.0, 0.0, Verdict::notApplicable, std::move(reason)};
}

std::vector<MeasuredCase> measure(const std::vector<HardCase>& cases, Workbench& bench,
                                  const ReportStability& report) {
  std::vector<MeasuredCase> measured;
  for (const HardCase& one : cases) {
    if (report)
      report(static_cast<double>(measured.size()) / static_cast<double>(cases.size()),
             one.id + ": " + one.title);
    measured.push_back({one.id, one.title, {}});
    try {
      measured.back().findings = one.measure(bench);
    } catch (const Error& error) {
      Finding failed = atMost("program", "", 1.0, 0.0, error.what());
      measured.back().findings = {std::move(failed)};
    }
  }
  return measured;
}

bool allHold(const std::vector<MeasuredCase>& cases) {
  for (const MeasuredCase& one : cases)
    for (const Finding& finding : one.findings)
      if (finding.verdict == Verdict::fail)
        return false;
  return true;
}

std::vector<glm::u8vec4> presented(const DrawnPicture& picture, const glm::dvec3& background) {
  const SavedState saved;
  const glm::ivec2& size = picture.size;
  const std::vector<glm::vec4> floats(picture.pixels.begin(), picture.pixels.end());
  const GlTexture drawn = textureOf(GL_RGBA32F, size, GL_FLOAT, upsideDown(floats, size).data());
  const GlTexture screen = textureOf(GL_RGBA8, size, GL_UNSIGNED_BYTE, nullptr);
  const GlFramebuffer framebuffer;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, screen.name(), 0);
  const PixelRect whole{{0, 0}, size};
  PicturePresenter().show(drawn.name(), {size.y, whole, whole}, background);
  std::vector<glm::u8vec4> levels(picture.pixels.size());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, levels.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return upsideDown(levels, size);
}

DrawnPicture Workbench::draw(Engine engine, const Scene& scene, const glm::ivec2& size) {
  switch (engine) {
  case Engine::reference:
    return {size, renderReference(scene, size).pixels};
  case Engine::rayCaster:
    return drawnPicture(rays().render(scene, size));
  case Engine::slices:
  case Engine::slicesBackToFront:
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
  return inEngines(bench, {Engine::reference, Engine::rayCaster, Engine::slices, Engine::cpu}, what, bounds,
                   reason, figure);
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

double finiteOrInfinite(double figure) {
  return std::isnan(figure) ? std::numeric_limits<double>::infinity() : figure;
}

double largestDifference(const glm::dvec4& a, const glm::dvec4& b) {
  double largest = 0.0;
  for (int channel = 0; channel < 4; ++channel)
    largest = std::max(largest, finiteOrInfinite(std::abs(a[channel] - b[channel])));
  return largest;
}

double largestDifference(const DrawnPicture& a, const DrawnPicture& b) {
  if (a.size != b.size)
    return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(largest, largestDifference(a.pixels[i], b.pixels[i]));
  return largest;
}

double differenceBeside(const glm::ivec3& voxel, const DrawnPicture& a, const DrawnPicture& b) {
  double largest = 0.0;
  for (int y = 0; y < a.size.y; ++y)
    for (int x = 0; x < a.size.x; ++x)
      if (std::abs(x - voxel.x) > 2 || std::abs(a.size.y - 1 - y - voxel.z) > 2)
        largest = std::max(largest, largestDifference(a.at(x, y), b.at(x, y)));
  return largest;
}

double largestAlphaError(const DrawnPicture& picture, double expected) {
  double largest = 0.0;
  for (const glm::dvec4& pixel : picture.pixels)
    largest = std::max(largest, finiteOrInfinite(std::abs(pixel.a - expected)));
  return largest;
}

int unsoundPixels(const DrawnPicture& picture) {
  const auto isSound = [](const glm::dvec4& pixel) {
    for (int channel = 0; channel < 4; ++channel)
      if (!std::isfinite(pixel[channel]) || pixel[channel] < 0.0)
        return false;
    return pixel.a <= 1.0 && std::max({pixel.r, pixel.g, pixel.b}) <= pixel.a + 1e-6;
  };
  return static_cast<int>(std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                        [&](const glm::dvec4& pixel) { return !isSound(pixel); }));
}

int visiblePixels(const DrawnPicture& picture) {
  return static_cast<int>(std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                        [](const glm::dvec4& pixel) { return pixel.a > 0.0; }));
}

Scene wholeVolume(std::shared_ptr<const Volume> volume, ShadingModel model, double lowest, double highest,
                  const glm::dvec3& direction) {
  Scene scene = rayThrough(std::move(volume), direction);
  scene.camera.heightMm = boxDiagonalMm(scene.volume->grid());
  scene.transferFunction = {smallestSpacingMm(scene.volume->grid()) * 4.0,
                            {{lowest, {0.9, 0.5, 0.3}, 0.0}, {highest, {1.0, 1.0, 0.9}, 0.6}}};
  scene.shading.model = model;
  scene.quality.stepVoxels = 0.5;
  return scene;
}

std::shared_ptr<const Volume> smoothVolume(int edge, double scale) {
  const double turn = 6.28318530717958647692 / edge;
  return volumeOf(centredGrid(glm::ivec3(edge), glm::dvec3(1.0)), [=](int i, int j, int k) {
    return scale * (50.0 + 50.0 * std::sin(turn * i) * std::cos(turn * j) * std::sin(turn * (k + 0.3 * i)));
  });
}

Finding takenOtherwise(const Workbench& bench, const Decisions& decisions, const std::string& what,
                       double bound, const std::string& reason,
                       const std::function<double(const Draw& draw)>& figure) {
  return withOpenGl(bench, "gl", what, [&] {
    RayCaster caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, decisions);
    const Draw draw = [&](const Scene& scene, const glm::ivec2& size) {
      const Image image = caster.render(scene, size);
      return DrawnPicture{size, {image.pixels.begin(), image.pixels.end()}};
    };
    return atMost("gl", what, figure(draw), bound, reason);
  });
}

} // namespace limn
