// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowProgram.h"

#include "app/MainWindow.h"
#include "app/Screenshot.h"
#include "scene/basics/Error.h"
#include "widgets/Theme.h"
#include "widgets/view/SurfaceFormat.h"

#include <QApplication>
#include <QMessageBox>

namespace limn {
namespace {

bool hasDisplay() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

} // namespace

int runWindow(int argc, char** argv, const WindowArguments& arguments) {
  if (!hasDisplay())
    throw Error(Error::Kind::openGl,
                "There is no display to open a window on; `limn render` makes pictures without "
                "one.");
  QSurfaceFormat::setDefaultFormat(limnSurfaceFormat());
  QApplication application(argc, argv);
  const QString theme =
      arguments.theme.empty() ? Settings().theme() : QString::fromStdString(arguments.theme);
  applyTheme(application, themeNamed(theme));
  if (const QString problem = openGlProblem(); !problem.isEmpty()) {
    if (arguments.screenshot.empty()) // someone is watching
      QMessageBox::critical(nullptr, QStringLiteral("Limn"), problem);
    throw Error(Error::Kind::openGl, problem.toStdString());
  }
  MainWindow window;
  window.show();
  if (arguments.screenshot.empty())
    window.keepSessions();
  if (!arguments.path.empty())
    window.openSource(QString::fromStdString(arguments.path), arguments.options);
  if (!arguments.screenshot.empty())
    saveScreenshotAtRest(window, QString::fromStdString(arguments.screenshot));
  return QApplication::exec();
}

} // namespace limn
