// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/exports/ExportDialog.h"

#include <QStringList>

class QCheckBox;
class QLabel;
class QListWidget;

namespace limn {

/// Asks how picture and look of a DICOM series go to an archive, with or without what the series says of its
/// patient, and saves them.
class DicomDialog : public ExportDialog {
  Q_OBJECT

public:
  explicit DicomDialog(WindowContext& context);

  static ActionLook look();
  static bool suits(const Scene& scene);

private:
  QString doing(double fraction) const override;
  void begin(bool isNew) override;
  void showScene(const Scene& scene) override;
  void layOut();
  /// What is on the left, in the shape that it is seen in, and large enough to be read in an archive.
  Scene sceneToSave() const;
  /// What the picture shows, and what other programs do not find in the look.
  void describe();
  void save();
  void sayWhatTheyCarry();

  QLabel* m_picture;
  QLabel* m_carries; ///< what the files say of the patient
  QCheckBox* m_anonymous;
  QListWidget* m_losses;
  QStringList m_shown; ///< in the list
};

} // namespace limn
