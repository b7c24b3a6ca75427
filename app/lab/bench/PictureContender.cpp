// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/bench/Contender.h"
#include "io/ImageFile.h"
#include "scene/basics/Error.h"

namespace limn {
namespace {

class PictureContender : public Contender {
public:
  PictureContender(std::string program, std::string renderer, StartDrawing start)
      : m_program(std::move(program)), m_renderer(std::move(renderer)), m_start(std::move(start)) {}

  std::string program() const override { return m_program; }
  std::string renderer() const override { return m_renderer; }

  FrameCost drawFirst(const Scene& scene) override {
    m_draw = nullptr;
    forgetPeak();
    m_residentBefore = residentMb();
    return costOf([&] {
      m_draw = m_start();
      m_picture = m_draw(scene);
      m_background = scene.image.background;
    });
  }

  FrameCost draw(const Scene& scene) override {
    return costOf([&] { m_picture = m_draw(scene); });
  }

  double peakMb() override { return peakResidentMb() - m_residentBefore; }

  void save(const std::filesystem::path& path) override { writeImage(path, m_picture, m_background, {}); }

private:
  std::string m_program;
  std::string m_renderer;
  StartDrawing m_start;
  DrawPicture m_draw;
  Image m_picture;
  glm::dvec3 m_background{0.0};
  double m_residentBefore = 0.0;
};

class AbsentContender : public Contender {
public:
  AbsentContender(std::string program, std::string reason)
      : m_program(std::move(program)), m_reason(std::move(reason)) {}

  std::string program() const override { return m_program; }
  std::string renderer() const override { return {}; }
  FrameCost drawFirst(const Scene&) override { refuse(); }
  FrameCost draw(const Scene&) override { refuse(); }
  double peakMb() override { refuse(); }
  void save(const std::filesystem::path&) override { refuse(); }

private:
  [[noreturn]] void refuse() const { throw Error(Error::Kind::usage, m_reason); }

  std::string m_program;
  std::string m_reason;
};

} // namespace

std::unique_ptr<Contender> absentContender(const std::string& program, const std::string& reason) {
  return std::make_unique<AbsentContender>(program, reason);
}

std::unique_ptr<Contender> pictureContender(const std::string& program, const std::string& renderer,
                                            StartDrawing start) {
  return std::make_unique<PictureContender>(program, renderer, std::move(start));
}

} // namespace limn
