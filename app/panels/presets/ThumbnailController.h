// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/framing/VisibleVoxels.h"
#include "scene/presets/Preset.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/view/pictures/PictureState.h"

#include <QTimer>

#include <map>
#include <optional>

namespace limn {

class PresetController;
struct WindowContext;

/// A small picture that is wanted.
struct Thumbnail {
  QString name; ///< of what it shows
  Scene scene;  ///< of the whole volume, with the camera that fits its shape
};

/// Draws small pictures on the processor, one after the other, of a copy of the volume that is no finer than
/// they need. For one thread at a time.
class ThumbnailPainter {
public:
  ThumbnailPainter();
  ~ThumbnailPainter();

  using IsEnded = std::function<bool()>;
  /// `showsNothing`: nothing of the volume is visible in the picture.
  using Drawn = std::function<void(const QString& name, const QImage& picture, bool showsNothing)>;

  /// Draws what is wanted, as far as it can be, with `size` pixels each; throws Cancelled some milliseconds
  /// after the word.
  void draw(const std::vector<Thumbnail>& wanted, const QSize& size, const IsEnded& isEnded,
            const Drawn& drawn);

private:
  Scene reducedScene(const Scene& scene, const IsEnded& isEnded);

  std::unique_ptr<DrawingEngine> m_engine;
  std::weak_ptr<const Volume> m_whole; ///< what `m_volume` was made of
  std::shared_ptr<const Volume> m_volume;
  Region m_wholeKeep;
  Region m_keep;
};

/// Has the list of presets show what each makes of the volume that is open: all of it however near the view
/// is, from the side of the view, cut as it is, lit with its model. Pictures are drawn in spare time: while
/// the ones of the view are at rest and nobody works with the window. They stay until the volume, or what
/// they show of it, is another one.
class ThumbnailController : public QObject {
  Q_OBJECT

public:
  ThumbnailController(WindowContext& context, const PresetController& presets);

  /// Draws what is missing without waiting for spare time, and tells `completed`.
  void drawNow();

  /// Whether every picture that is wanted of what is at rest is in the list.
  bool isComplete() const { return m_phase == Phase::complete; }

signals:
  void completed(); ///< every picture that is wanted of what is at rest is in the list

private:
  enum class Phase { moving, waiting, drawing, complete };
  void noteState(const PictureState& state);
  void notePresets();
  void showScene(const Scene& scene);
  void begin();
  void stop();
  std::vector<Thumbnail> missing();
  Camera cameraOf(const Scene& scene);
  void findObject(const Scene& scene);
  void receive(const QString& name, const QImage& picture, bool showsNothing);

  WindowContext& m_context;
  const PresetController& m_presets;
  QTimer m_wait; ///< from the picture at rest on
  Phase m_phase = Phase::moving;
  std::vector<Thumbnail> m_wanted;
  std::map<QString, Scene> m_shown; ///< what is seen in the list
  std::shared_ptr<const Volume> m_volume;
  Camera m_camera;                       ///< from which they are seen
  std::optional<VisibleVoxels> m_object; ///< what they are framed on, of the volume with these:
  Region m_objectKeep;
  CropBox m_objectCrop;
  std::shared_ptr<ThumbnailPainter> m_painter; ///< of that volume; for the thread of `m_work`
  BackgroundWork m_work;
};

/// Whether two cameras see so nearly the same that a small picture of one does for the other: within 12
/// degrees, a quarter of the size and a sixth of the picture's height.
bool seeAlike(const Camera& a, const Camera& b);

} // namespace limn
