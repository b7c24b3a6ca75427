// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/figure/FigureDialog.h"
#include "app/files/figure/FigurePreview.h"
#include "app/files/opening/SeriesDialog.h"
#include "app/panels/presets/LookController.h"
#include "app/pictures/PicturedWindow.h"
#include "app/privacy/Marks.h"

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
  for (const char* name :
       {"settings", "guide", "shortcuts", "stability", "about", "savePicture", "saveSessionAs", "openFile",
        "openFolder", "savePreset", "importLooks", "exportLook", "saveTurntable", "exportSurface"})
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

TEST_F(DialogPictures, ofAReportOnLooks) {
  LookReport dialog(
      QStringLiteral("Imported looks"),
      QStringLiteral("Presets imported: 2. Files refused: 1. What became of each file:"),
      {{"CT_Bones.clut", "imported as CT_Bones", {}, false},
       {"ramp.itf",
        "imported as ramp",
        {"Its values from 0 to 1 were stretched over -1024 to 3071.",
         "Its mask became points, outside which the opacity is 0."},
        false},
       {"skull.tfi",
        "not imported",
        {"Cannot read skull.tfi: it is damaged or cut off (near its character 812); save the look again in "
         "the program that made it."},
        true}},
      window.get());
  dialog.show();
  take(QStringLiteral("dialog-look-report"), dialog);
}

TEST_F(DialogPictures, ofKeptViews) {
  takeDialogOf("keepView", QStringLiteral("dialog-keep-view"));
  session().setViews({{"The left ear", scene().camera}, {"Fracture from above", scene().camera}},
                     QStringLiteral("keep views"));
  takeDialogOf("manageViews", QStringLiteral("dialog-views"));
}

TEST_F(DialogPictures, ofSavingToDicom) {
  test::writeMarkedSeries(folder.path() / "series");
  ASSERT_TRUE(open(pathTo("series")));
  ASSERT_TRUE(rest());
  takeDialogOf("saveDicom", QStringLiteral("dialog-dicom"));
}

TEST_F(DialogPictures, ofEveryMenu) {
  for (QAction* entry : window->menuBar()->actions()) {
    QMenu& menu = *entry->menu();
    menu.popup(window->mapToGlobal(QPoint(0, 0)));
    take(QStringLiteral("menu-") + entry->text().remove(QLatin1Char('&')).toLower(), menu);
    menu.close();
  }
  for (QMenu* menu : window->findChildren<QMenu*>())
    if (menu->actions().contains(&action("view-anterior"))) {
      menu->popup(window->mapToGlobal(QPoint(0, 0)));
      take(QStringLiteral("menu-look-from"), *menu);
      menu->close();
      break;
    }
}

} // namespace
} // namespace limn
