// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <optional>

class QLabel;
class QStatusBar;

namespace limn {

class PictureStatus;
struct PictureState;
struct Probe;

/// What the status bar says of volume, pointer and picture.
class StatusTexts {
public:
  explicit StatusTexts(QStatusBar& bar);

  /// Also whether its voxels stay on the disk. Null: none.
  void showVolume(const Volume* volume);
  void showProbe(const std::optional<Probe>& probe, const Volume* volume);
  void showPicture(const PictureState& state, const Scene& scene);

private:
  QLabel* m_volume;
  QLabel* m_probe;
  PictureStatus* m_picture;
};

} // namespace limn
