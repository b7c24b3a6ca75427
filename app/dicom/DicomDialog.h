// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/saving/WorkDialog.h"

#include <QStringList>

class QCheckBox;
class QLabel;
class QListWidget;

namespace limn {

/// Asks how picture and look go to an archive: with or without what the series says of its patient. It writes
/// nothing.
class DicomDialog : public WorkDialog {
  Q_OBJECT

public:
  explicit DicomDialog(QWidget* parent);

  bool isAnonymous() const;

  /// What the picture shows, and in which size.
  void setPicture(const QString& sentence);

  /// What other programs do not find in the look, a sentence each.
  void setLosses(const QStringList& sentences);

signals:
  void saveRequested();

private:
  QString doing(double fraction) const override;
  void sayWhatTheyCarry();

  QLabel* m_picture;
  QLabel* m_carries; ///< what the files say of the patient
  QCheckBox* m_anonymous;
  QListWidget* m_losses;
  QStringList m_shown; ///< in the list
};

} // namespace limn
