// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/saving/WorkDialog.h"

#include <glm/glm.hpp>

#include <QStringList>

class QComboBox;
class QFormLayout;

namespace limn {

class NumberField;

/// Asks how a turntable is saved. It draws nothing.
class TurntableDialog : public WorkDialog {
  Q_OBJECT

public:
  /// Without `hasVideo` it offers frames alone, and says why.
  TurntableDialog(bool hasVideo, QWidget* parent);

  /// What the window shows, from left to right: of several, one is asked for, at first `usual`; the same
  /// ones keep what was chosen.
  void setPictures(const QStringList& names, int usual);
  int picture() const;

  void setSize(const glm::ivec2& pixels);
  glm::ivec2 size() const;
  int frames() const;
  double framesPerSecond() const;
  bool wantsVideo() const;

signals:
  void saveRequested();

private:
  QString doing(double fraction) const override;
  void showLength();

  NumberField* m_width;
  NumberField* m_height;
  NumberField* m_frames;
  NumberField* m_perSecond;
  QComboBox* m_kind;
  QComboBox* m_picture;
  QFormLayout* m_form;
};

} // namespace limn
