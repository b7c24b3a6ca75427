// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figure/FigureDialog.h"
#include "app/figure/FigurePreview.h"
#include "app/opening/SeriesDialog.h"
#include "app/pictures/PicturedWindow.h"

#include <QMenu>
#include <QMenuBar>

// Pictures of what opens above the window.

namespace limn {
namespace {

class DialogPictures : public test::PicturedWindow {
protected:
  void SetUp() override {
    PicturedWindow::SetUp();
    ASSERT_TRUE(openVolume());
  }
};

TEST_F(DialogPictures, ofEveryDialog) {
  for (const char* name : {"settings", "shortcuts", "stability", "about", "savePicture", "saveSessionAs",
                           "openFile", "openFolder", "savePreset", "saveTurntable", "exportSurface"})
    takeDialogOf(name, QStringLiteral("dialog-") + QLatin1String(name));
}

TEST_F(DialogPictures, ofAFigure) {
  action("saveFigure").trigger();
  FigureDialog& dialog = *window->findChild<FigureDialog*>();
  const auto hasErrors = [&] {
    const std::vector<FigurePanel>& panels = dialog.preview().figure().panels;
    return dialog.preview().pictures().size() == panels.size() && panels.front().errorLevels;
  };
  ASSERT_TRUE(test::waitUntil(hasErrors));
  take(QStringLiteral("dialog-figure"), dialog);
}

TEST_F(DialogPictures, ofTheChoiceOfASeries) {
  SeriesDialog dialog({{.number = 1,
                        .description = "Head 1.0 J40s",
                        .modality = "CT",
                        .dims = {512, 512, 214},
                        .thicknessMm = 1.0,
                        .date = "2023-11-08",
                        .folder = "S0003"},
                       {.number = 2,
                        .description = "Topogram 0.6 T20f",
                        .modality = "CT",
                        .dims = {512, 512, 2},
                        .thicknessMm = 0.6,
                        .date = "2023-11-08",
                        .folder = "S0001"}},
                      window.get());
  dialog.open();
  take(QStringLiteral("dialog-series"), dialog);
}

TEST_F(DialogPictures, ofEveryMenu) {
  for (QAction* entry : window->menuBar()->actions()) {
    QMenu& menu = *entry->menu();
    menu.popup(window->mapToGlobal(QPoint(0, 0)));
    take(QStringLiteral("menu-") + entry->text().remove(QLatin1Char('&')).toLower(), menu);
    menu.close();
  }
}

} // namespace
} // namespace limn
