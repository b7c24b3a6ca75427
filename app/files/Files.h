// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/exports/SurfaceDialog.h"
#include "app/files/figure/FigureDialog.h"
#include "app/files/opening/DropController.h"
#include "app/files/opening/OpeningController.h"
#include "app/files/opening/RemarksController.h"
#include "app/files/saving/PictureSaving.h"
#include "app/files/saving/SavingController.h"
#include "app/files/saving/SessionSafety.h"

namespace limn {

/// What files tell of the rest of the window when they are made.
struct FileSources {
  std::function<SessionDocument()> session; ///< of this moment
  std::function<FigureLooks()> looks;
  std::function<CurveChoice()> curve;
};

/// What comes into the window and leaves it: opening, saving and keeping of sessions, figures and exports.
class Files : public QObject {
  Q_OBJECT

public:
  Files(WindowContext& context, FileSources sources);

  OpeningController& opening() { return m_opening; }
  const OpeningController& opening() const { return m_opening; }
  DropController& drops() { return m_drops; }
  SavingController& saving() { return m_saving; }
  SessionSafety& safety() { return m_safety; }

  /// Says what there is to say of what was opened, keeps it from being lost, and remembers where it lies.
  void noteOpened(const LoadedScene& loaded, const Request& request);

signals:
  void closeRequested();

private:
  WindowContext& m_context;
  FileSources m_sources;
  PictureSaving m_pictures;
  SavingController m_saving;
  SessionSafety m_safety;
  OpeningController m_opening;
  RemarksController m_remarks;
  DropController m_drops;
};

} // namespace limn
