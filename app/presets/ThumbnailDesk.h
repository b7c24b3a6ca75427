// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/presets/ThumbnailWorker.h"
#include "scene/presets/Preset.h"
#include "widgets/view/pictures/PictureState.h"

#include <QThread>
#include <QTimer>

#include <functional>
#include <map>

namespace limn {

class PresetBrowser;
class Session;

/// Has the list of presets show what each makes of the volume that is open: from where it is looked at, cut
/// as it is, lit with its model. Pictures are drawn in spare time: while the ones of the view are at rest and
/// nobody works with the window. They stay until the volume, or what they show of it, is another one.
class ThumbnailDesk : public QObject {
  Q_OBJECT

public:
  struct Partners {
    Session& session;
    PresetBrowser& browser;
    /// The presets in the order in which they are wanted, as they fit the volume.
    std::function<std::vector<Preset>()> presets;
    std::function<double()> aspect; ///< of the pictures of the view, width over height
  };
  ThumbnailDesk(Partners with, QObject* parent);
  ~ThumbnailDesk() override;

  /// How far the pictures of the view are.
  void noteState(const PictureState& state);

  /// Pictures of another volume leave the list.
  void showScene(const Scene& scene);

  /// There are other presets.
  void notePresets();

  /// Draws what is missing without waiting for spare time, and tells `completed`.
  void drawNow();

  /// Whether every picture that is wanted of what is at rest is in the list.
  bool isComplete() const { return m_phase == Phase::complete; }

signals:
  void completed(); ///< every picture that is wanted of what is at rest is in the list

private:
  enum class Phase { moving, waiting, drawing, complete };
  void begin();
  void stop();
  std::vector<Thumbnail> missing();
  Camera cameraOf(const Scene& scene);
  void receive(int order, const QString& name, const QImage& picture, bool showsNothing);

  Partners m_with;
  QThread m_thread;
  ThumbnailWorker* m_worker; ///< on the thread
  QTimer m_wait;             ///< from the picture at rest on
  Phase m_phase = Phase::moving;
  int m_order = 0;
  std::vector<Thumbnail> m_wanted;  ///< of the last order
  std::map<QString, Scene> m_shown; ///< what is seen in the list
  std::shared_ptr<const Volume> m_volume;
  Camera m_camera; ///< from which they are seen
};

/// Whether two cameras see so nearly the same that a small picture of one does for the other: within 12
/// degrees, a quarter of the size and a sixth of the picture's height.
bool seeAlike(const Camera& a, const Camera& b);

} // namespace limn
