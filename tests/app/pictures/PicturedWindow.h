// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/WindowHarness.h"
#include "app/pictures/Album.h"

#include <optional>

namespace limn::test {

/// A new window of the size of its screen, of which pictures are taken. The environment says which: of the
/// size LIMN_PICTURES_SIZE (1280x800, in points: a scale of 200 % has twice the pixels), in the theme
/// LIMN_PICTURES_THEME (dark), in the language LIMN_PICTURES_LANGUAGE (English), with the volume
/// LIMN_PICTURES_VOLUME (a coarse phantom), into the folder LIMN_PICTURES (one that vanishes).
class PicturedWindow : public WindowHarness {
protected:
  void SetUp() override;

  /// The volume that pictures show, drawn and complete; `otherwise` where the environment names none.
  [[nodiscard]] bool openVolume(const char* otherwise = "phantom:8");

  /// What the screen shows of the window, once its pictures are complete.
  QImage shown();
  void take(const QString& name);
  /// One part of the window, or a dialog, alone. A dialog must fit the screen.
  void take(const QString& name, QWidget& part);
  /// Triggers an action and takes the dialog that it opens, which is closed again.
  void takeDialogOf(const char* action, const QString& name);

  QAction& action(const char* name) const { return *window->findChild<QAction*>(QLatin1String(name)); }

  std::optional<Album> album;
};

} // namespace limn::test
