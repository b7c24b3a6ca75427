// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/exports/SurfaceDialog.h"
#include "app/files/figure/FigureDialog.h"
#include "app/files/opening/OpeningController.h"
#include "app/files/saving/PictureSaving.h"
#include "app/files/saving/SavingController.h"
#include "app/files/saving/SessionSafety.h"
#include "app/files/saving/SliceSaving.h"

#include <QObject>
#include <QStringList>
#include <QWidget>

namespace limn {

/// Shows where files may fall that are held over a window.
class DropHint : public QWidget {
  Q_OBJECT

public:
  explicit DropHint(QWidget& window);

  /// Over the whole window but for its frame; `text` says what letting go does.
  void showOver(const QString& text);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QString m_text;
};

/// Takes the files that are dropped on a window and says what each is: looks, and others, of which the first
/// is to be opened, or all as labels. While they are held over it a frame shows that they may fall there.
class DropController : public QObject {
  Q_OBJECT

public:
  /// The window accepts drops from now on.
  explicit DropController(QWidget& window);

signals:
  void looksDropped(const QStringList& paths);
  void sourcesDropped(const QStringList& paths);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void tell(const QStringList& paths);

  DropHint* m_hint;
};

/// What files tell of the rest of the window when they are made.
struct FileSources {
  std::function<SessionDocument()> session; ///< of this moment
  std::function<FigureLooks()> looks;
  std::function<CurveChoice()> curve;
};

/// What there is to say of a volume that was opened, with what can be done about it; what a person has
/// answered since is no longer said. Of a DICOM series it offers the looks that lie beside it, once it has
/// searched them beside the event loop, and once what is asked meanwhile has been answered.
class RemarksController : public QObject {
  Q_OBJECT

public:
  /// `opening` asks for a spacing.
  RemarksController(WindowContext& context, OpeningController& opening);

  /// What to say of what was loaded and is open now.
  void show(const LoadedScene& loaded, const Request& request);

  /// Whether it has looks to offer once something else has been answered.
  bool isWaiting() const { return m_isWaiting; }

  /// What it knows, for a window that takes this one's place.
  struct Memory {
    std::vector<Message> notes;
    QString figure;
    Message ofFigure;
    bool isSaid = false; ///< still
  };
  Memory memory() const;
  /// Of the same volume, which is shown already.
  void takeOver(const Memory& memory);

signals:
  /// The figure that was opened, of which the window shows a part, is to be seen whole.
  void figureAsked(const QString& file);

private:
  bool isSaid() const;
  void say();
  void showWhole();
  void lookForLooks(const LoadedScene& loaded, const Request& request);
  void offer(const std::shared_ptr<const Volume>& volume, const QStringList& looks);
  void followScene(const Scene& scene);

  WindowContext& m_context;
  OpeningController& m_opening;
  BackgroundWork m_searching;
  std::vector<Message> m_notes;
  QString m_figure;                       ///< the file of one of which the window shows a part
  Message m_ofFigure;                     ///< which of the notes says so
  std::shared_ptr<const Volume> m_volume; ///< of which something is said
  QString m_said;                         ///< what the bar shows of it
  bool m_isWaiting = false;
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
  SliceSaving& slices() { return m_slices; }
  SessionSafety& safety() { return m_safety; }

  /// Whether the program may end: nothing is being drawn into a file or waits to be saved elsewhere, or
  /// somebody says to end it all the same.
  bool mayQuit();

  /// Whether something is being read or written, or waits to be saved elsewhere.
  bool isBusy() const;

  /// Says what there is to say of what was opened, keeps it from being lost, and remembers where it lies.
  void noteOpened(const LoadedScene& loaded, const Request& request);

  RemarksController& remarks() { return m_remarks; }

signals:
  void closeRequested();
  /// Somebody wants to set how far saved pictures of physical light are drawn.
  void savedPathsWanted();

private:
  QStringList underWay() const; ///< what is being drawn into files, in words

  WindowContext& m_context;
  FileSources m_sources;
  PictureSaving m_pictures;
  SavingController m_saving;
  SliceSaving m_slices;
  SessionSafety m_safety;
  OpeningController m_opening;
  RemarksController m_remarks;
  DropController m_drops;
};

} // namespace limn
