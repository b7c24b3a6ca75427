// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measure/bench/Contender.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <QProcess>

#include <sstream>

namespace limn {
namespace {

class RivalContender : public Contender {
public:
  RivalContender(std::string name, const RivalCommand& command, std::string volumePath)
      : m_name(std::move(name)), m_volumePath(std::move(volumePath)) {
    QStringList arguments;
    for (const std::string& argument : command.arguments)
      arguments << QString::fromStdString(argument);
    m_process.start(QString::fromStdString(command.program.string()), arguments);
    if (!m_process.waitForStarted(-1))
      throw Error(Error::Kind::other, command.program.string() + " cannot be started: " +
                                          m_process.errorString().toStdString() + ".");
    try {
      m_renderer = answer();
    } catch (...) {
      end();
      throw;
    }
  }

  ~RivalContender() override { end(); }

  std::string program() const override { return m_name; }
  std::string renderer() const override { return m_renderer; }
  bool lightsBothSides() const override { return true; }
  FrameCost drawFirst(const Scene& scene) override { return cost("first", scene); }
  FrameCost draw(const Scene& scene) override { return cost("draw", scene); }
  double peakMb() override { return std::stod(asked("peak\n")); }
  void save(const std::filesystem::path& path) override { asked("save " + path.string() + "\n"); }

private:
  // It leaves when nothing more can be asked.
  void end() {
    m_process.closeWriteChannel();
    if (!m_process.waitForFinished(5000))
      m_process.kill();
    m_process.waitForFinished(5000);
  }

  FrameCost cost(const std::string& word, const Scene& scene) {
    const std::string json = sceneToJson(scene, m_volumePath);
    FrameCost cost;
    std::istringstream(asked(word + " " + std::to_string(json.size()) + "\n" + json)) >> cost.ms >>
        cost.cpuMs;
    return cost;
  }

  std::string asked(const std::string& question) {
    m_process.write(question.data(), static_cast<qint64>(question.size()));
    return answer();
  }

  // What follows `ok` in the next line.
  std::string answer() {
    while (!m_process.canReadLine())
      if (!m_process.waitForReadyRead(-1))
        throw Error(Error::Kind::other,
                    "The program that draws with " + m_name + " ended unexpectedly: " + lastWords() + ".");
    const std::string line = m_process.readLine().trimmed().toStdString();
    if (line.starts_with("ok"))
      return line.size() > 3 ? line.substr(3) : std::string();
    throw Error(Error::Kind::usage, line.starts_with("error ") ? line.substr(6) : line);
  }

  std::string lastWords() {
    m_process.waitForFinished(5000);
    const QList<QByteArray> lines = m_process.readAllStandardError().trimmed().split('\n');
    return lines.last().isEmpty() ? "it said nothing" : lines.last().toStdString();
  }

  std::string m_name;
  std::string m_volumePath;
  std::string m_renderer;
  QProcess m_process;
};

} // namespace

std::unique_ptr<Contender> rivalContender(const std::string& name, const RivalCommand& command,
                                          const std::string& volumePath) {
  return std::make_unique<RivalContender>(name, command, volumePath);
}

} // namespace limn
