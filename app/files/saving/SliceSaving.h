// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/PlaneSettings.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/planes/SlicePicture.h"

#include <QObject>

namespace limn {

struct WindowContext;

/// Slices as pictures, as they are seen at the moment of asking, with what stands on them but for the
/// crosshair. A volume is open.
class SliceSaving : public QObject {
  Q_OBJECT

public:
  explicit SliceSaving(WindowContext& context);

  /// Puts the slice in a plane on the clipboard, as large as on screen and with every mark.
  void copy(PatientPlane plane);
  /// Asks how large it is saved and with which marks, and where: as a picture of 8 bits, PNG or TIFF. It is
  /// drawn and written beside the event loop.
  void save(PatientPlane plane);
  /// Whether one is being written.
  bool isBusy() const { return m_writing.isRunning(); }

private:
  SeenSlice sliceIn(PatientPlane plane) const;

  WindowContext& m_context;
  BackgroundWork m_writing;
};

} // namespace limn
