// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/making/Turntable.h"
#include "app/files/exports/ExportDialog.h"

#include <QStringList>
#include <QTimer>

#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace limn {

class NumberField;
class SavingController;

/// Asks how what is open is saved from all around, and saves it: as frames, or as a video where there is a
/// program that makes one.
class TurntableDialog : public ExportDialog {
  Q_OBJECT

public:
  /// `saving` says how files call the volume.
  TurntableDialog(WindowContext& context, const SavingController* saving);

  static ActionLook look();
  static bool suits(const Scene& scene) { return scene.volume != nullptr; }

protected:
  void done(int result) override;

private:
  QString doing(double fraction) const override;
  double atOnePace(double fraction) const override;
  void begin(bool isNew) override;
  void showScene(const Scene&) override;
  void layOut(bool hasVideo);
  /// What the window shows, from left to right: of several, one is asked for, at first `usual`; the same
  /// ones keep what was chosen.
  void setPictures(const QStringList& names, int usual);
  /// From where the turn may begin beside the view of now.
  void setStarts(const std::vector<NamedView>& views);
  int frames() const;
  double framesPerSecond() const;
  glm::ivec2 size() const; ///< of each frame: a video has even sides
  bool isVideo() const;
  /// The angle of a choice, or the choice of an angle.
  void takeTurn(int choice);
  void showTurn();
  void save();
  Turntable wanted() const;
  /// Says how long it is; finds out beside the event loop whether it begins smaller than what is shown.
  void showLength();
  void sayLength();
  bool saysLength() const;     ///< and not how far drawing is, or what came of it
  QString drawingText() const; ///< how long drawing takes

  const SavingController& m_saving;
  NumberField* m_width;
  NumberField* m_height;
  NumberField* m_frames;
  NumberField* m_perSecond;
  NumberField* m_angle; ///< degrees
  QComboBox* m_turn;    ///< whole, half, or another
  QCheckBox* m_marks;
  QComboBox* m_kind;
  QComboBox* m_picture;
  QComboBox* m_start;
  QFormLayout* m_form;
  BackgroundWork m_fitting;
  QTimer m_soon;                       ///< until what was said of what is shown is found out anew
  std::optional<double> m_sizeAtFirst; ///< of what is shown; absent until it is known
  QString m_length;                    ///< what is said of it
  int m_framesDrawn = 2;               ///< of what was begun last
  bool m_isVideoDrawn = false;
};

} // namespace limn
