// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/BackgroundWork.h"
#include "io/surfaces/SurfaceMaker.h"

#include <QPointer>

class QAction;
class QWidget;

namespace limn {

class OpenDocument;
class SaveNotes;
class Session;
class Settings;
class SurfaceDialog;
class TransferFunctionCanvas;

/// Exports isosurfaces of what is open, beside the event loop.
class SurfaceDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Parts {
    const Session& session;
    const OpenDocument& document;
    const TransferFunctionCanvas& curve; ///< whose pinned value or selected point is begun with
    Settings& settings;
    SaveNotes& notes;
    QAction& exportSurface; ///< asks for one
    QWidget& window;
  };

  explicit SurfaceDesk(const Parts& parts);

private:
  void show();
  void makeDialog();
  void showScene(const Scene& scene);
  void estimate();
  void exportSurface();
  SurfaceOrder order() const;

  Parts m_parts;
  QPointer<SurfaceDialog> m_dialog;
  Scene m_estimated; ///< of which the last estimate was made
  BackgroundWork m_estimate;
  BackgroundWork m_work;
};

} // namespace limn
