// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/presets/ThumbnailPainter.h"
#include "scene/presets/Preset.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/view/pictures/PictureState.h"

#include <QTimer>

#include <map>

namespace limn {

class PresetController;
struct WindowContext;

/// Has the list of presets show what each makes of the volume that is open: from where it is looked at, cut
/// as it is, lit with its model. Pictures are drawn in spare time: while the ones of the view are at rest and
/// nobody works with the window. They stay until the volume, or what they show of it, is another one.
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
  void receive(const QString& name, const QImage& picture, bool showsNothing);

  WindowContext& m_context;
  const PresetController& m_presets;
  QTimer m_wait; ///< from the picture at rest on
  Phase m_phase = Phase::moving;
  std::vector<Thumbnail> m_wanted;
  std::map<QString, Scene> m_shown; ///< what is seen in the list
  std::shared_ptr<const Volume> m_volume;
  Camera m_camera;                             ///< from which they are seen
  std::shared_ptr<ThumbnailPainter> m_painter; ///< of that volume; for the thread of `m_work`
  BackgroundWork m_work;
};

/// Whether two cameras see so nearly the same that a small picture of one does for the other: within 12
/// degrees, a quarter of the size and a sixth of the picture's height.
bool seeAlike(const Camera& a, const Camera& b);

} // namespace limn
