// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/making/Turntable.h"

#include "app/core/making/ChildProcess.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "io/reading/HeaderText.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace limn {
namespace {

namespace fs = std::filesystem;

// What of the work a video is, beside its frames.
constexpr double shareOfFrames = 0.95;

// What of the work frames are the search for their cameras is.
constexpr double shareOfCameras = 0.02;

// Between views of so many of a turn what reaches farthest reaches at most 1 - cos 1.8° = 0.05 % farther.
constexpr int mostMeasured = 100;

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
                 const DescribeScene& describe, const MarkPicture& mark, std::vector<Message>& notes) {
  MakingOptions drawing = order;
  drawing.isFilm = true;
  drawing.effort = partOf(order.effort, shareOfCameras, 1.0);
  const std::vector<Scene> scenes = framesOf(turntable, partOf(order.effort, 0.0, shareOfCameras));
  makeEach(scenes, turntable.size, drawing, [&](std::size_t index, const MadePicture& picture) {
    for (const Message& note : remarksOf(picture))
      if (std::ranges::find(notes, note) == notes.end())
        notes.push_back(note);
    writeImage(folder / frameName(static_cast<int>(index)),
               mark ? mark(picture.image, picture.scene) : picture.image, picture.scene.image.background,
               describe(picture.scene));
  });
}

// The last line of what it prints says most.
std::string lastLine(const std::string& printed) {
  const std::string_view text = trimmed(printed);
  return std::string(trimmed(text.substr(text.find_last_of('\n') + 1)));
}

std::string decimal(double number) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

[[noreturn]] void failEncoding(const std::string& why) {
  throw Error(Error::Kind::other,
              Message::tr("The video cannot be made (%1); choose another place, or a folder for the frames.")
                  .arg(why));
}

// Most players need an even size and halved colours.
void encode(const fs::path& frames, const fs::path& video, double framesPerSecond, const Effort& effort) {
  std::optional<ChildProcess> process;
  try {
    process.emplace(videoProgram(),
                    std::vector<std::string>{
                        "-nostdin", "-y", "-loglevel", "error", "-framerate", decimal(framesPerSecond), "-i",
                        (frames / "frame-%04d.png").string(), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                        "-pix_fmt", "yuv420p", "-f", "mp4", video.string()},
                    ChildProcess::Errors::among);
  } catch (const Error& error) {
    failEncoding(error.what());
  }
  constexpr int askMs = 50;
  std::string printed;
  while (const auto more = process->read(askMs)) {
    printed += *more;
    if (effort.isCancelled && effort.isCancelled())
      throw Cancelled();
  }
  // Of a full disk it tells in words alone.
  if (!process->succeeded() || !trimmed(printed).empty())
    failEncoding(lastLine(printed));
}

std::string endingOf(const fs::path& path) {
  return lowerCase(path.extension().string());
}

void makeFolderFor(const fs::path& folder) {
  if (const Message why = makeFolders(folder); !why.empty())
    throw Error(
        Error::Kind::other,
        Message::tr("The folder %1 cannot be made (%2); choose another one.").arg(folder.string()).arg(why));
}

} // namespace

Camera turned(const Camera& camera, double angle) {
  const glm::dvec3 axis = uprightAxis(camera);
  Camera result = camera;
  result.position = camera.target + rotatedAbout(axis, angle, camera.position - camera.target);
  result.up = rotatedAbout(axis, angle, camera.up);
  return result;
}

Turn::Turn(const Scene& scene, int views, double aspect, double cameraAspect, const Effort& effort,
           double angleDeg)
    : m_scene(scene), m_views(views),
      m_stepDeg(angleDeg < 360.0 ? angleDeg / std::max(1, views - 1) : angleDeg / views), m_aspect(aspect) {
  if (!scene.volume)
    return;
  const Grid& grid = scene.volume->grid();
  VisibleVoxels visible = visibleVoxels(scene, partOf(effort, 0.0, 0.5));
  if (!isFramed(scene.camera, grid, visible, cameraAspect))
    return;
  std::vector<Camera> cameras;
  const int step = std::max(1, views / mostMeasured);
  for (int view = 0; view < views; view += step)
    cameras.push_back(turnedTo(view));
  m_distance = framedDistance(cameras, grid, visible, aspect, partOf(effort, 0.5, 1.0));
  m_visible = std::move(visible);
}

Camera Turn::turnedTo(int index) const {
  return index % m_views == 0 ? m_scene.camera : turned(m_scene.camera, glm::radians(m_stepDeg * index));
}

Camera Turn::view(int index) const {
  const Camera camera = turnedTo(index);
  return m_visible ? framedFrom(camera, m_scene.volume->grid(), *m_visible, m_aspect, m_distance) : camera;
}

std::vector<Scene> framesOf(const Turntable& turntable, const Effort& effort) {
  const double aspect = 1.0 * turntable.size.x / turntable.size.y;
  const Turn turn(turntable.scene, turntable.frames, aspect, turntable.cameraAspect.value_or(aspect),
                  partOf(effort, 0.0, 0.5), turntable.angleDeg);
  std::vector<Scene> scenes(static_cast<std::size_t>(turntable.frames), turntable.scene);
  forEachPiece(turntable.frames, partOf(effort, 0.5, 1.0), [&](int frame) {
    Scene& scene = scenes[static_cast<std::size_t>(frame)];
    scene.camera = turn.view(frame);
    scene.image.width = turntable.size.x;
    scene.image.height = turntable.size.y;
  });
  return scenes;
}

double sizeAtFirst(const Turntable& turntable, const Effort& effort) {
  const double aspect = 1.0 * turntable.size.x / turntable.size.y;
  const Turn turn(turntable.scene, turntable.frames, aspect, turntable.cameraAspect.value_or(aspect), effort,
                  turntable.angleDeg);
  const auto extent = [](const Camera& camera) {
    return camera.projection == Camera::Projection::orthographic
               ? camera.heightMm
               : glm::distance(camera.position, camera.target);
  };
  return std::min(1.0, extent(turntable.scene.camera) / extent(turn.view(0)));
}

bool isVideo(const fs::path& path) {
  return endingOf(path) == ".mp4";
}

std::string videoProgram() {
  return findProgram("ffmpeg");
}

void requireTurntablePlace(const fs::path& path, int frames) {
  static const std::vector<std::string> others = words(
      ".apng .avi .bmp .exr .gif .jpeg .jpg .m4v .mkv .mov .mpeg .mpg .ogv .pdf .png .tif .tiff .webm .webp "
      ".wmv");
  std::error_code unknown;
  if (std::ranges::count(others, endingOf(path)) > 0 && !fs::is_directory(path, unknown))
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

double shareDrawn(double fraction, bool isVideo) {
  const double ofFrames = isVideo ? fraction / shareOfFrames : fraction;
  return std::clamp((ofFrames - shareOfCameras) / (1.0 - shareOfCameras), 0.0, 1.0);
}

std::vector<Message> writeTurntable(const fs::path& path, const Turntable& turntable,
                                    const MakingOptions& order, const DescribeScene& describe,
                                    const MarkPicture& mark) {
  requireTurntablePlace(path, turntable.frames);
  std::vector<Message> notes;
  if (!isVideo(path)) {
    makeFolderFor(path);
    writeFrames(path, turntable, order, describe, mark, notes);
    return notes;
  }
  requireWritable(path);
  // Frames carry no scenes there: they vanish.
  std::optional<ScratchFolder> frames;
  try {
    frames.emplace();
  } catch (const Error& error) {
    throw Error(Error::Kind::other,
                Message::tr("The frames of the video have no place (%1); make room in the folder for "
                            "temporary files.")
                    .arg(error.sentence()));
  }
  MakingOptions most = order;
  most.effort = partOf(order.effort, 0.0, shareOfFrames);
  writeFrames(
      frames->path(), turntable, most, [](const Scene&) { return std::string(); }, mark, notes);
  replaceAtomically(path, [&](const fs::path& temporary) {
    encode(frames->path(), temporary, turntable.framesPerSecond, order.effort);
  });
  if (order.effort.report)
    order.effort.report(1.0);
  return notes;
}

} // namespace limn
