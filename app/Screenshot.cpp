// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Screenshot.h"

#include "app/MainWindow.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/pictures/PictureState.h"

#include <QApplication>
#include <QScreen>
#include <QTimer>

#include <cstdio>

namespace limn {
namespace {

void grabAndQuit(MainWindow& window, const QString& path) {
  // What the screen shows, where the platform lets us see it (it does not under Wayland).
  QPixmap picture = window.screen()->grabWindow(window.winId());
  if (picture.isNull())
    picture = window.grab();
  const bool saved = picture.save(path);
  if (!saved)
    std::fprintf(stderr, "limn: Cannot write the screenshot %s; check that its folder exists.\n",
                 qPrintable(path));
  QApplication::exit(saved ? 0 : 1);
}

} // namespace

void saveScreenshotAtRest(MainWindow& window, const QString& path) {
  QObject::connect(&window.loader(), &VolumeLoader::failed, &window,
                   [](const QString&, const QString& sentence) {
                     std::fprintf(stderr, "limn: %s\n", qPrintable(sentence));
                     QApplication::exit(3);
                   });
  QObject::connect(&window.loader(), &VolumeLoader::seriesFound, &window,
                   [](const QString&, const std::vector<SeriesSummary>& series) {
                     std::fprintf(stderr, "limn: The folder holds %zu series; choose one with --series.\n",
                                  series.size());
                     QApplication::exit(3);
                   });
  if (!window.loader().isLoading()) {
    QTimer::singleShot(0, &window, [&window, path] { grabAndQuit(window, path); });
    return;
  }
  QObject::connect(&window.view(), &CompareView::pictureStateChanged, &window,
                   [&window, path](const PictureState& state) {
                     // The labels and panels catch up before the picture is taken.
                     if ((state.resting || state.processorIsDone) && window.view().scene().volume)
                       QTimer::singleShot(0, &window, [&window, path] { grabAndQuit(window, path); });
                   });
}

} // namespace limn
