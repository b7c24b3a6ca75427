// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/making/ChildProcess.h"
#include "app/lab/bench/Contender.h"
#include "io/reading/HeaderText.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <optional>
#include <sstream>

namespace limn {
namespace {

class RivalContender : public Contender {
public:
  RivalContender(std::string name, const RivalCommand& command, std::string volumePath)
      : m_name(std::move(name)), m_volumePath(std::move(volumePath)) {
    try {
      m_process.emplace(command.program, command.arguments, ChildProcess::Errors::apart);
    } catch (const Error& error) {
      throw Error(Error::Kind::other, command.program.string() + " cannot be started: " + error.what() + ".");
    }
    m_renderer = answer();
  }

  // It leaves when nothing more can be asked.
  ~RivalContender() override {
    m_process->closeInput();
    readToTheEnd();
  }

  std::string program() const override { return m_name; }
  std::string renderer() const override { return m_renderer; }
  bool lightsBothSides() const override { return true; }
  FrameCost drawFirst(const Scene& scene) override { return cost("first", scene); }
  FrameCost draw(const Scene& scene) override { return cost("draw", scene); }
  double peakMb() override { return std::stod(asked("peak\n")); }
  void save(const std::filesystem::path& path) override { asked("save " + path.string() + "\n"); }

private:
  // For some seconds; what does not end by then is ended.
  void readToTheEnd() {
    while (const auto more = m_process->read(5000))
      if (more->empty())
        return;
  }

  FrameCost cost(const std::string& word, const Scene& scene) {
    const std::string json = sceneToJson(scene, m_volumePath);
    FrameCost cost;
    std::istringstream(asked(word + " " + std::to_string(json.size()) + "\n" + json)) >> cost.ms >>
        cost.cpuMs;
    return cost;
  }

  std::string asked(const std::string& question) {
    m_process->write(question);
    return answer();
  }

  // What follows `ok` in the next line.
  std::string answer() {
    const auto next = m_process->readLine();
    if (!next)
      throw Error(Error::Kind::other,
                  "The program that draws with " + m_name + " ended unexpectedly: " + lastWords() + ".");
    const std::string line(trimmed(*next));
    if (line.starts_with("ok"))
      return line.size() > 3 ? line.substr(3) : std::string();
    throw Error(Error::Kind::usage, line.starts_with("error ") ? line.substr(6) : line);
  }

  std::string lastWords() {
    m_process->succeeded(); // waits for all that it says
    const std::string errors = m_process->errors();
    const std::string_view said = trimmed(errors);
    return said.empty() ? "it said nothing" : std::string(trimmed(said.substr(said.find_last_of('\n') + 1)));
  }

  std::string m_name;
  std::string m_volumePath;
  std::string m_renderer;
  std::optional<ChildProcess> m_process;
};

} // namespace

std::unique_ptr<Contender> rivalContender(const std::string& name, const RivalCommand& command,
                                          const std::string& volumePath) {
  return std::make_unique<RivalContender>(name, command, volumePath);
}

} // namespace limn
