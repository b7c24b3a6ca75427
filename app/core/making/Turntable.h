// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/drawing/PictureMaker.h"
#include "scene/framing/Framing.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// A picture from all around.
struct Turntable {
  Scene scene;                        ///< the first frame
  glm::ivec2 size{512, 512};          ///< of each frame, pixels
  int frames = 90;                    ///< 2..mostFrames, for the whole of it
  double angleDeg = 360.0;            ///< > 0; of less than a turn the last frame is its end
  double framesPerSecond = 25.0;      ///< of a video, > 0
  std::optional<double> cameraAspect; ///< of the picture that the scene's camera stands for; absent: of these
};

/// As many as names of four digits tell apart.
inline constexpr int mostFrames = 9999;

/// The camera after so much of a turn, radians, anticlockwise seen from above: about the axis of the patient
/// that stands most nearly upright in the picture, through the target.
Camera turned(const Camera& camera, double angle);

/// A turn about a scene, in views. Where its camera is framed (scene/framing), each of them is, with one
/// distance for all, for pictures of `aspect`; of more than a hundred views the distance is that of so many
/// among them. A camera that stands otherwise turns as it is.
class Turn {
public:
  /// `cameraAspect` is that of the picture that the camera may be framed for; `views` ≥ 1 (2 of less than a
  /// whole turn, whose ends are views). Throws Cancelled.
  Turn(const Scene& scene, int views, double aspect, double cameraAspect, const Effort& effort = {},
       double angleDeg = 360.0);

  Camera view(int index) const;

private:
  Camera turnedTo(int index) const;

  const Scene& m_scene;
  int m_views;
  double m_stepDeg; // from view to view
  double m_aspect;
  std::optional<VisibleVoxels> m_visible; // absent: as it stands
  double m_distance = 0.0;
};

/// The scene of each frame; of a camera that is not framed the first is the scene itself. Throws Cancelled.
std::vector<Scene> framesOf(const Turntable& turntable, const Effort& effort = {});

/// As large as the picture that its camera stands for shows things, 1, or smaller, the first frame shows
/// them: where that is framed its camera steps back so far that nothing is cut off on the way. Throws
/// Cancelled.
double sizeAtFirst(const Turntable& turntable, const Effort& effort = {});

/// What a frame's file says of its scene (io/scenefile).
using DescribeScene = std::function<std::string(const Scene& scene)>;

/// The picture of a scene with what else shall stand in it.
using MarkPicture = std::function<Image(Image picture, const Scene& scene)>;

/// Whether a path asks for a video rather than for a folder of frames: .mp4.
bool isVideo(const std::filesystem::path& path);

/// The program that makes videos; empty where it is not installed.
std::string videoProgram();

/// Refuses a path that means neither: a video of another kind, a single picture, a video where there is
/// nothing to make it with, or a folder with more frames than will be written, which would be taken for the
/// same turn. Else a folder that is there may be called as it likes. Throws Error (usage).
void requireTurntablePlace(const std::filesystem::path& path, int frames);

/// How much of its frames is drawn (0..1) once so much of the whole work is done (0..1): their cameras are
/// found before, and a video is made of them after. They take about as long each.
double shareDrawn(double fraction, bool isVideo);

/// Draws all frames and writes them: a PNG each, frame-0001.png, into a folder, which is made where there is
/// none, or a video, complete or untouched. Each is what `mark` makes of the picture, where there is one. Of
/// frames that are cancelled those drawn stay. Returns one sentence each that was noteworthy. Throws Error,
/// of kind usage where there is nothing to make videos with, and Cancelled.
std::vector<Message> writeTurntable(const std::filesystem::path& path, const Turntable& turntable,
                                    const MakingOptions& order, const DescribeScene& describe,
                                    const MarkPicture& mark = {});

} // namespace limn
