// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Files.h"
#include "app/frame/Frame.h"
#include "app/panels/Panels.h"
#include "app/picture/PictureArea.h"
#include "app/window/WindowContext.h"

#include <QMainWindow>

namespace limn {

/// What a window gives to the one that takes its place.
struct WindowHandover {
  std::unique_ptr<OpenWork> open;
  SessionDocument session; ///< what is shown beside it
  PictureArea::Memory picture;
  Panels::Memory panels;
  RemarksController::Memory remarks;
  WindowContext::Said said;                ///< but for what is said anew
  std::optional<SessionSafety::Kept> kept; ///< that is told of
  Frame::Memory frame;
  bool keepsSessions = false;
  std::unique_ptr<SessionKeeper> keeper; ///< null: there is none
};

/// The window: the picture in the middle, presets left, properties right, the curve below. Its four parts
/// register what they offer; it connects what passes between them, and holds nothing that a part could hold.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  /// `folders` is where settings, presets and unsaved sessions are kept, `memory` how much it may take for
  /// volumes and what engines make of them (default: MemoryBudget's, each time). `open` is what the window
  /// before gave away, shown once this one has taken over; null: nothing is open.
  explicit MainWindow(UserFolders folders = UserFolders::ofThisUser(),
                      const std::optional<MemoryBudget>& memory = {}, QWidget* parent = nullptr,
                      std::unique_ptr<OpenWork> open = nullptr);
  ~MainWindow() override;

  /// Starts loading a volume, DICOM folder, scene, session or Limn picture.
  void openSource(const QString& source, const SourceOptions& options = {}) {
    m_files.opening().open(source, options);
  }

  /// The same of what is named before anything is shown: what was left unsaved is then offered beside it.
  void openNamed(const QString& source, const SourceOptions& options = {}) {
    m_files.safety().sayWithFirst();
    openSource(source, options);
  }

  /// From now on the session is autosaved, and what an earlier window left behind is offered.
  void keepSessions() { m_files.safety().begin(); }

  /// Closes where nobody is there to be asked, because the system ends the program. What is unsaved is kept
  /// as by closing; where it cannot be, the next window is offered what was autosaved.
  void endUnasked();

  /// Offers a tour of the window to who has not seen it.
  void offerTour() { m_frame.tour().offer(); }

  /// Whether something is under way, in the user's hand or asked that would be lost with the window.
  bool isBusy() const;

  /// Gives all that it shows to another window, and is to be destroyed before that is made. Nobody is asked:
  /// nothing is lost.
  WindowHandover handOver();

  /// Goes on where the window before was left. Once shown: pictures have their shape then. What is open came
  /// with the constructor.
  void takeOver(WindowHandover before);

  /// What a session file of this moment says, but for where its volume is and its own place.
  SessionDocument sessionDocument() const;

  ThumbnailController& thumbnails() { return m_panels.thumbnails(); }
  CompareView& view() { return m_context.view; }
  const VolumeLoader& loader() const { return m_files.opening().loader(); }

signals:
  /// In the settings: "system" or a code.
  void languageChosen(const QString& language);

protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  FileSources fileSources();
  void connectPictureAndPanels();
  void connectFiles();
  void showLoaded(const LoadedScene& loaded, const Histogram& histogram, const Request& request);
  void closeVolume();
  void end();

  WindowContext m_context;
  PictureArea m_picture;
  Panels m_panels;
  Files m_files;
  Frame m_frame;
  bool m_asks = true; ///< before it closes
};

} // namespace limn
