// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pictures/PicturedWindow.h"

#include "app/language/Language.h"
#include "widgets/theme/LookStyle.h"

#include <QDialog>
#include <QScreen>

namespace limn::test {
namespace {

QString given(const char* variable, const char* otherwise) {
  return qEnvironmentVariable(variable, QLatin1String(otherwise));
}

// "1280x800-dark-", with the scale where it is not 100 % and the language where one was asked for
// ("1280x800-de-dark-").
QString prefixOf(const QString& size, const QString& theme, double pixelsPerPoint) {
  const int percent = qRound(100.0 * pixelsPerPoint);
  const QString scale = percent == 100 ? QString() : QStringLiteral("at%1-").arg(percent);
  return QStringLiteral("%1-%2%3-").arg(size, scale, theme);
}

QDialog* visibleDialog() {
  for (QWidget* window : QApplication::topLevelWidgets())
    if (auto* dialog = qobject_cast<QDialog*>(window); dialog && dialog->isVisible())
      return dialog;
  return nullptr;
}

} // namespace

void PicturedWindow::SetUp() {
  const QString size = given("LIMN_PICTURES_SIZE", "1280x800");
  const QString theme = given("LIMN_PICTURES_THEME", "dark");
  const QString language = given("LIMN_PICTURES_LANGUAGE", "");
  if (!language.isEmpty())
    useLanguage(*QCoreApplication::instance(), language);
  applyTheme(*static_cast<QApplication*>(QApplication::instance()), themeNamed(theme));
  // A window that had another size before divides itself differently.
  window = std::make_unique<MainWindow>(UserFolders::below(folder.path()));
  view().setRefinesAtRest(false);
  window->setGeometry(0, 0, size.section(QLatin1Char('x'), 0, 0).toInt(),
                      size.section(QLatin1Char('x'), 1).toInt());
  window->show();
  WindowHarness::SetUp();
  album.emplace(given("LIMN_PICTURES", pathTo("pictures").toLocal8Bit().constData()).toStdString(),
                prefixOf(size, language.isEmpty() ? theme : language + QLatin1Char('-') + theme,
                         window->devicePixelRatioF()));
}

bool PicturedWindow::openVolume(const char* otherwise) {
  return open(given("LIMN_PICTURES_VOLUME", otherwise)) && rest();
}

QImage PicturedWindow::shown() {
  // Labels and panels catch up; where that changes the size of the picture, it is drawn anew.
  for (int turn = 0; turn < 2; ++turn) {
    QCoreApplication::processEvents();
    EXPECT_TRUE(waitUntil([this] { return !scene().volume || view().pictureState().resting; }));
  }
  window->repaint();
  return window->screen()->grabWindow(window->winId()).toImage();
}

void PicturedWindow::take(const QString& name) {
  album->add(shown(), name);
}

void PicturedWindow::take(const QString& name, QWidget& part) {
  QCoreApplication::processEvents();
  const bool isTooLarge = part.width() > window->width() || part.height() > window->height();
  EXPECT_FALSE(part.isWindow() && isTooLarge)
      << name.toStdString() << " has " << part.width() << "×" << part.height()
      << " points, more than a screen of " << window->width() << "×" << window->height();
  album->add(part.grab().toImage(), name);
}

void PicturedWindow::takeDialogOf(const char* action, const QString& name) {
  bool isTaken = false;
  const auto takeAndClose = [&](QDialog* dialog) {
    if (!dialog || isTaken)
      return;
    isTaken = true; // at once: while it is taken, the timer runs
    take(name, *dialog);
    dialog->close();
  };
  QTimer look; // while the action returns only once its dialog is answered
  QObject::connect(&look, &QTimer::timeout, &look,
                   [&] { takeAndClose(qobject_cast<QDialog*>(QApplication::activeModalWidget())); });
  look.start(10);
  this->action(action).trigger();
  takeAndClose(visibleDialog());
  EXPECT_TRUE(isTaken) << action << " opens no dialog";
}

} // namespace limn::test
