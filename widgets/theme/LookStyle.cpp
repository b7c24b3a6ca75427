// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/theme/LookStyle.h"

#include "widgets/theme/Icons.h"
#include "widgets/theme/Theme.h"

#include <QApplication>
#include <QStyleFactory>

namespace limn {
namespace {

// The name of our own icon, or null where Qt's stays.
const char* ownIcon(QStyle::StandardPixmap icon) {
  switch (icon) {
  case QStyle::SP_DirIcon:
  case QStyle::SP_DirOpenIcon:
  case QStyle::SP_DirClosedIcon:
  case QStyle::SP_DirLinkIcon:
    return "folder";
  case QStyle::SP_FileIcon:
  case QStyle::SP_FileLinkIcon:
    return "file";
  case QStyle::SP_ComputerIcon:
  case QStyle::SP_DesktopIcon:
  case QStyle::SP_DriveHDIcon:
  case QStyle::SP_DriveNetIcon:
    return "computer";
  case QStyle::SP_DirHomeIcon:
    return "home";
  case QStyle::SP_ArrowBack:
    return "arrow-back";
  case QStyle::SP_ArrowForward:
    return "arrow-forward";
  case QStyle::SP_FileDialogToParent:
    return "arrow-up";
  case QStyle::SP_FileDialogNewFolder:
    return "folder-new";
  case QStyle::SP_FileDialogListView:
    return "view-names";
  case QStyle::SP_FileDialogDetailedView:
    return "view-details";
  case QStyle::SP_ToolBarHorizontalExtensionButton:
    return "more-tools";
  case QStyle::SP_LineEditClearButton:
    return "clear";
  case QStyle::SP_MessageBoxQuestion:
    return "question";
  case QStyle::SP_MessageBoxInformation:
    return "information";
  case QStyle::SP_MessageBoxWarning:
  case QStyle::SP_MessageBoxCritical:
    return "warning";
  default:
    return nullptr;
  }
}

} // namespace

LookStyle::LookStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

QIcon LookStyle::standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const {
  if (const char* name = ownIcon(icon))
    return themedIcon(QLatin1String(name), QGuiApplication::palette());
  return QProxyStyle::standardIcon(icon, option, widget);
}

int LookStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                         QStyleHintReturn* answer) const {
  switch (hint) {
  case SH_DialogButtonBox_ButtonsHaveIcons:
  case SH_ComboBox_Popup: // a list below its box: over it, Fusion has too little room for the rows of our
                          // sheet
    return 0;
  case SH_Menu_Scrollable: // one column that scrolls: several would be wider than the screen
    return 1;
  default:
    return QProxyStyle::styleHint(hint, option, widget, answer);
  }
}

// Qt's own twelve pixels are narrower than what our sheet puts around an icon, which then is not drawn.
int LookStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  constexpr int room = 28;
  return metric == PM_ToolBarExtensionExtent ? room : QProxyStyle::pixelMetric(metric, option, widget);
}

ThemeChoice themeNamed(const QString& name) {
  if (name == QStringLiteral("dark"))
    return ThemeChoice::dark;
  if (name == QStringLiteral("contrast"))
    return ThemeChoice::contrast;
  return name == QStringLiteral("light") ? ThemeChoice::light : ThemeChoice::system;
}

void applyTheme(QApplication& application, ThemeChoice choice) {
  // An unset palette lets the platform's own show through, which is what `system` has to ask.
  QApplication::setPalette(QPalette());
  const Look look = choice == ThemeChoice::system  ? lookOf(QApplication::palette())
                    : choice == ThemeChoice::light ? Look::light
                    : choice == ThemeChoice::dark  ? Look::dark
                                                   : Look::contrast;
  QApplication::setStyle(new LookStyle);
  QApplication::setPalette(themePalette(look));
  application.setStyleSheet(themeStyleSheet(look));
}

} // namespace limn
