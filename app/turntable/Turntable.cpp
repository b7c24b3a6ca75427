// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/turntable/Turntable.h"

#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <cmath>
#include <numbers>
#include <set>

namespace limn {
namespace {

namespace fs = std::filesystem;

// What of the work a video is, beside its frames.
constexpr double shareOfFrames = 0.95;

glm::dvec3 rotatedAbout(const glm::dvec3& axis, double angle, const glm::dvec3& vector) {
  // Rodrigues' formula.
  return std::cos(angle) * vector + std::sin(angle) * glm::cross(axis, vector) +
         (1.0 - std::cos(angle)) * glm::dot(axis, vector) * axis;
}

glm::dvec3 uprightAxis(const Camera& camera) {
  const glm::dvec3 up = basisOf(camera).up;
  const glm::dvec3 size = glm::abs(up);
  const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  glm::dvec3 upright(0.0);
  upright[axis] = up[axis] < 0.0 ? -1.0 : 1.0;
  return upright;
}

std::string frameName(int frame) {
  char name[32];
  std::snprintf(name, sizeof name, "frame-%04d.png", frame + 1);
  return name;
}

void writeFrames(const fs::path& folder, const Turntable& turntable, const MakingOptions& order,
                 const DescribeScene& describe, std::set<std::string>& notes) {
  makeEach(framesOf(turntable), turntable.size, order, [&](std::size_t index, const MadePicture& picture) {
    for (const Message& note : picture.notes)
      notes.insert(translated(note).toStdString());
    writeImage(folder / frameName(static_cast<int>(index)), picture.image, picture.scene.image.background,
               describe(picture.scene));
  });
}

// The last line of what it prints says most.
QString lastLine(const QByteArray& printed) {
  const QList<QByteArray> lines = printed.trimmed().split('\n');
  return QString::fromLocal8Bit(lines.isEmpty() ? QByteArray() : lines.back().trimmed());
}

// Most players need an even size and halved colours.
void encode(const fs::path& frames, const fs::path& video, double framesPerSecond, const Effort& effort) {
  QProcess process;
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(QString::fromStdString(videoProgram()),
                {QStringLiteral("-nostdin"), QStringLiteral("-y"), QStringLiteral("-loglevel"),
                 QStringLiteral("error"), QStringLiteral("-framerate"), QString::number(framesPerSecond),
                 QStringLiteral("-i"), QString::fromStdString((frames / "frame-%04d.png").string()),
                 QStringLiteral("-vf"), QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2"),
                 QStringLiteral("-pix_fmt"), QStringLiteral("yuv420p"), QStringLiteral("-f"),
                 QStringLiteral("mp4"), QString::fromStdString(video.string())});
  constexpr int askMs = 50;
  while (!process.waitForFinished(askMs) && process.state() != QProcess::NotRunning)
    if (effort.isCancelled && effort.isCancelled()) {
      process.kill();
      process.waitForFinished();
      throw Cancelled();
    }
  const QByteArray printed = process.readAll();
  // Of a full disk it tells in words alone.
  if (process.error() == QProcess::FailedToStart || process.exitStatus() != QProcess::NormalExit ||
      process.exitCode() != 0 || !printed.trimmed().isEmpty())
    throw Error(
        Error::Kind::other,
        QObject::tr("The video cannot be made (%1); choose another place, or a folder for the frames.")
            .arg(process.error() == QProcess::FailedToStart ? process.errorString() : lastLine(printed))
            .toStdString());
}

QString endingOf(const fs::path& path) {
  return QString::fromStdString(path.extension().string()).toLower();
}

void makeFolderFor(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw Error(Error::Kind::other, Message::tr("The folder %1 cannot be made (%2); choose another one.")
                                        .arg(folder.string())
                                        .arg(failed.message()));
}

} // namespace

Camera turned(const Camera& camera, double angle) {
  const glm::dvec3 axis = uprightAxis(camera);
  Camera result = camera;
  result.position = camera.target + rotatedAbout(axis, angle, camera.position - camera.target);
  result.up = rotatedAbout(axis, angle, camera.up);
  return result;
}

std::vector<Scene> framesOf(const Turntable& turntable) {
  std::vector<Scene> scenes(static_cast<std::size_t>(turntable.frames), turntable.scene);
  for (int frame = 0; frame < turntable.frames; ++frame) {
    Scene& scene = scenes[static_cast<std::size_t>(frame)];
    if (frame > 0)
      scene.camera = turned(scene.camera, 2.0 * std::numbers::pi * frame / turntable.frames);
    scene.image.width = turntable.size.x;
    scene.image.height = turntable.size.y;
  }
  return scenes;
}

bool isVideo(const fs::path& path) {
  return endingOf(path) == QLatin1String(".mp4");
}

std::string videoProgram() {
  return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).toStdString();
}

void requireTurntablePlace(const fs::path& path, int frames) {
  static const QStringList others =
      QStringLiteral(".apng .avi .bmp .exr .gif .jpeg .jpg .m4v .mkv .mov .mpeg .mpg .ogv .pdf .png .tif "
                     ".tiff .webm .webp .wmv")
          .split(QLatin1Char(' '));
  std::error_code unknown;
  if (others.contains(endingOf(path)) && !fs::is_directory(path, unknown))
    throw Error(Error::Kind::usage,
                Message::tr("Cannot write %1: a turntable is a video with the ending .mp4, or frames in a "
                            "folder, whose name needs no ending.")
                    .arg(path.string()));
  if (isVideo(path) && videoProgram().empty())
    throw Error(Error::Kind::usage,
                Message::tr("No video can be made, because ffmpeg is not installed; install the package "
                            "ffmpeg or save frames into a folder."));
  if (const std::string next = frameName(frames); fs::exists(path / next, unknown))
    throw Error(
        Error::Kind::usage,
        Message::tr("%1 holds %2 of a longer turntable, which would follow on these %3 frames; choose "
                    "another folder, or delete it.")
            .arg(path.string())
            .arg(next)
            .arg(frames));
}

std::vector<std::string> writeTurntable(const fs::path& path, const Turntable& turntable,
                                        const MakingOptions& order, const DescribeScene& describe) {
  requireTurntablePlace(path, turntable.frames);
  std::set<std::string> notes;
  if (!isVideo(path)) {
    makeFolderFor(path);
    writeFrames(path, turntable, order, describe, notes);
    return {notes.begin(), notes.end()};
  }
  // Frames carry no scenes there: they vanish.
  const QTemporaryDir frames;
  if (!frames.isValid())
    throw Error(Error::Kind::other,
                Message::tr("The frames of the video have no place (%1); make room in the folder for "
                            "temporary files.")
                    .arg(frames.errorString().toStdString()));
  const fs::path folder(frames.path().toStdString());
  MakingOptions most = order;
  most.effort = partOf(order.effort, 0.0, shareOfFrames);
  writeFrames(
      folder, turntable, most, [](const Scene&) { return std::string(); }, notes);
  replaceAtomically(path, [&](const fs::path& temporary) {
    encode(folder, temporary, turntable.framesPerSecond, order.effort);
  });
  if (order.effort.report)
    order.effort.report(1.0);
  return {notes.begin(), notes.end()};
}

} // namespace limn
