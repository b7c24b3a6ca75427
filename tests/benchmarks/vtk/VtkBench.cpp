// SPDX-License-Identifier: GPL-3.0-or-later
// Draws Limn's scenes with VTK for `limn bench --rivals`, in a process of its own: the questions and answers
// on stdin and stdout are those of app/lab/bench/Contender.h.
#include "VtkStage.h"
#include "app/commands/Arguments.h"
#include "app/commands/Syntax.h"
#include "io/ImageFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <vtkAutoInit.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2)

namespace limn {
namespace {

// One conversation.
class Rival {
public:
  Rival(VtkMapper mapper, SourceOptions options) : m_mapper(mapper), m_options(std::move(options)) {}

  std::string rendererOf(const glm::ivec2& size) {
    m_stage = std::make_unique<VtkStage>(m_mapper, size);
    return m_stage->renderer();
  }

  std::string answer(const std::string& line) {
    const auto space = line.find(' ');
    const std::string word = line.substr(0, space);
    const std::string rest = space == std::string::npos ? std::string() : line.substr(space + 1);
    if (word == "first" || word == "draw")
      return draw(std::stoul(rest), word == "first");
    if (word == "peak")
      return std::to_string(peakResidentMb() - m_residentBefore);
    if (word == "save") {
      writeImage(rest, m_stage->picture(), glm::dvec3(0.0), {});
      return {};
    }
    throw Error(Error::Kind::usage, "\"" + word + "\" is not a question to this program.");
  }

private:
  std::string draw(std::size_t bytes, bool isFirst) {
    std::string json(bytes, '\0');
    std::cin.read(json.data(), static_cast<std::streamsize>(bytes));
    SceneDocument document = parseScene(json, "the scene on stdin");
    if (isFirst) {
      m_volume = loadScene(document.volume, m_options, {}).scene.volume;
      m_stage->setVolume(m_volume);
      forgetPeak();
      m_residentBefore = residentMb();
    }
    document.scene.volume = m_volume;
    const FrameCost cost = m_stage->draw(document.scene);
    return std::to_string(cost.ms) + " " + std::to_string(cost.cpuMs);
  }

  VtkMapper m_mapper;
  SourceOptions m_options;
  std::unique_ptr<VtkStage> m_stage;
  std::shared_ptr<const Volume> m_volume;
  double m_residentBefore = 0.0;
};

void say(const std::string& line) {
  std::cout << line << std::endl;
}

int converse(VtkMapper mapper, const SourceOptions& options) {
  // VTK ends the process where it cannot open a display.
  if (!std::getenv("DISPLAY")) {
    say("error VTK needs an X display for OpenGL; start one for the benchmark with `xvfb-run -a limn bench "
        "…`.");
    return 4;
  }
  Rival rival(mapper, options);
  say("ok " + rival.rendererOf({512, 512}));
  for (std::string line; std::getline(std::cin, line);)
    try {
      say("ok " + rival.answer(line));
    } catch (const std::exception& error) {
      say(std::string("error ") + error.what());
    }
  return 0;
}

} // namespace
} // namespace limn

int main(int argc, char** argv) {
  limn::ProgramSyntax program("limn_bench_vtk", "Draws scenes with VTK for limn bench --rivals.", "");
  std::string mapper;
  limn::SourceArguments arguments;
  limn::CommandSyntax words = program.words();
  words.option("MAPPER", mapper, "gpu or fixedpoint").required().oneOf({"gpu", "fixedpoint"});
  limn::addSourceOptions(words, arguments);
  if (const std::optional<int> status = program.run(argc, argv))
    return *status;
  return limn::converse(mapper == "gpu" ? limn::VtkMapper::gpu : limn::VtkMapper::fixedPoint,
                        limn::sourceOptions(arguments));
}
