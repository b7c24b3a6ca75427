// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/EndSignals.h"
#include "app/MainWindow.h"
#include "app/SpokenWindow.h"
#include "app/commands/CommandLine.h"
#include "app/guide/GuideWindow.h"
#include "app/language/Language.h"
#include "scene/basics/Error.h"
#include "widgets/theme/Icons.h"
#include "widgets/theme/LookStyle.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/drawing/DriverRecovery.h"
#include "widgets/view/pictures/PictureState.h"

#include <QApplication>
#include <QEvent>
#include <QScreen>
#include <QTimer>
#include <QWindow>

#include <cstdio>
#include <functional>

namespace limn {
namespace {

// Runs something once the platform shows a window, which it does in its own time.
class OnceExposed : public QObject {
public:
  OnceExposed(QWidget& window, std::function<void()> run) : QObject(&window), m_run(std::move(run)) {
    window.windowHandle()->installEventFilter(this);
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Expose && qobject_cast<QWindow*>(watched)->isExposed()) {
      watched->removeEventFilter(this);
      QTimer::singleShot(0, this, m_run); // after it has painted
    }
    return false;
  }

private:
  std::function<void()> m_run;
};

void grabAndQuit(MainWindow& window, const QString& path) {
  // Paint what is due, at once.
  window.repaint();
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

bool isRefined(const PictureState& state) {
  return state.resting && !state.refines;
}

// Saves a picture of the whole window once its volume is loaded, drawn as finely as it gets and seen in the
// list of presets, then quits the program: with status 0, 3 where loading failed, or 1 where saving did.
void saveScreenshotAtRest(MainWindow& window, const QString& path) {
  QObject::connect(&window.loader(), &VolumeLoader::failed, &window,
                   [](const QString&, const QString& sentence) {
                     std::fprintf(stderr, "limn: %s\n", qPrintable(sentence));
                     QApplication::exit(3);
                   });
  QObject::connect(&window.loader(), &VolumeLoader::seriesFound, &window,
                   [](const QString&, const std::shared_ptr<const DicomFolder>& dicom) {
                     std::fprintf(stderr, "limn: The folder holds %zu series; choose one with --series.\n",
                                  dicom->summaries().size());
                     QApplication::exit(3);
                   });
  if (!window.loader().isLoading()) {
    new OnceExposed(window, [&window, path] { grabAndQuit(window, path); });
    return;
  }
  QObject::connect(&window.view(), &CompareView::told, &window, [&window, path](const ViewNews& news) {
    // The labels and panels catch up before the picture is taken; where that changes its
    // size, it is drawn anew.
    if (isRefined(news.state) && window.view().scene().volume)
      QTimer::singleShot(0, &window, [&window] {
        if (isRefined(window.view().pictureState()))
          window.thumbnails().drawNow();
      });
  });
  QObject::connect(&window.thumbnails(), &ThumbnailController::completed, &window, [&window, path] {
    if (isRefined(window.view().pictureState()))
      grabAndQuit(window, path);
  });
}

// Theme and language as asked for, or as set. Returns that language.
QString dress(QApplication& application, const std::string& theme, const std::string& language) {
  const Settings settings;
  const QString spoken = language.empty() ? settings.language() : QString::fromStdString(language);
  useLanguage(application, spoken);
  applyTheme(application, themeNamed(theme.empty() ? settings.theme() : QString::fromStdString(theme)));
  QApplication::setWindowIcon(programIcon());
  QApplication::setDesktopFileName(QStringLiteral("org.limn.Limn")); // whose icon Wayland shows
  return spoken;
}

void runGuideWindow(const std::string& words) {
  int count = 1;
  char name[] = "limn";
  char* arguments[] = {name, nullptr};
  QApplication application(count, arguments);
  dress(application, {}, {});
  GuideWindow guide;
  guide.look(QString::fromStdString(words));
  guide.show();
  QApplication::exec();
}

int runWindow(int argc, char** argv, const WindowArguments& arguments) {
  if (!hasDisplay())
    throw Error(Error::Kind::openGl,
                "There is no display to open a window on; `limn render` makes pictures without one.");
  QSurfaceFormat::setDefaultFormat(limnSurfaceFormat());
  QApplication application(argc, argv);
  const QString language = dress(application, arguments.theme, arguments.language);
  SpokenWindow spoken(UserFolders::ofThisUser(), arguments.options.read.memory, language);
  MainWindow& window = spoken.window(); // the first
  const EndSignals endSignals;
  QObject::connect(&endSignals, &EndSignals::endAsked, &spoken, [&spoken] {
    spoken.window().endUnasked();
    QApplication::exit(0); // also where a dialog is open
  });
  window.show();
  if (arguments.screenshot.empty()) {
    window.keepSessions();
    window.offerTour();
  }
  if (!arguments.path.empty())
    window.openNamed(QString::fromStdString(arguments.path), arguments.options);
  if (!arguments.screenshot.empty())
    saveScreenshotAtRest(window, QString::fromStdString(arguments.screenshot));
  return QApplication::exec();
}

} // namespace
} // namespace limn

int main(int argc, char** argv) {
  return limn::runCommandLine(argc, argv, {limn::runWindow, limn::runGuideWindow});
}
