// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/privacy/Marks.h"
#include "io/dicom/SyntheticSeries.h"

// What the title bar calls a volume, and whether it names the patient, in the window.

namespace limn {
namespace {

class TitleWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    test::writeMarkedSeries(folder.path() / "head");
    ASSERT_TRUE(open(pathTo("head")));
  }

  MessageBar& question() const { return *window->findChild<MessageBar*>(QStringLiteral("patientBar")); }
  bool titleNames() const { return window->windowTitle().contains(QStringLiteral("ZEBEDEE")); }
  std::optional<bool> setting() const {
    return Settings(UserFolders::below(folder.path()).settings).patientIsShown();
  }
  void answer(const char* text) {
    for (QToolButton* button : question().findChildren<QToolButton*>())
      if (button->text() == QLatin1String(text))
        return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << text;
  }
  void openAnother() {
    ASSERT_TRUE(open(QStringLiteral("phantom:16")));
    EXPECT_FALSE(question().isVisible()) << "it shows nobody";
    ASSERT_TRUE(open(pathTo("head")));
  }
};

TEST_F(TitleWindow, namesNobodyUntilItWasAsked) {
  EXPECT_TRUE(question().isVisible());
  EXPECT_FALSE(titleNames());
  openAnother();
  EXPECT_TRUE(question().isVisible()) << "still not answered";
  EXPECT_FALSE(setting().has_value());
}

TEST_F(TitleWindow, namesThePatientOnceThatWasChosen) {
  answer("Name the patient");
  EXPECT_FALSE(question().isVisible());
  EXPECT_TRUE(titleNames());
  EXPECT_EQ(setting(), true);
  openAnother();
  EXPECT_FALSE(question().isVisible()) << "it is asked once";
  EXPECT_TRUE(titleNames());
}

TEST_F(TitleWindow, namesNobodyWhereThatWasChosenUntilTheMenuSaysOtherwise) {
  answer("Do not show it");
  EXPECT_FALSE(question().isVisible());
  EXPECT_EQ(setting(), false);
  openAnother();
  EXPECT_FALSE(question().isVisible());
  EXPECT_FALSE(titleNames());
  window->findChild<QAction*>(QStringLiteral("patientInTitle"))->trigger();
  EXPECT_TRUE(titleNames());
}

// Four slices of a patient in a folder that names nobody.
void writeDescribed(const std::filesystem::path& folder, const std::string& series,
                    const std::string& description) {
  for (int i = 1; i <= 4; ++i)
    test::slice(i, i)
        .text(0x00100010, "PN", "ZEBEDEE^QUILLON")
        .text(0x0020000E, "UI", series)
        .text(0x0008103E, "LO", description)
        .write(folder / (series + "." + std::to_string(i)));
}

TEST_F(TitleWindow, saysWhatASeriesIsUnlessThatNamesThePatient) {
  answer("Do not show it");
  writeDescribed(folder.path() / "thorax", "1.2.3.5", "Thorax 1.0 B30f");
  ASSERT_TRUE(open(pathTo("thorax")));
  const auto begins = [this](const char* title) {
    EXPECT_TRUE(window->windowTitle().startsWith(QLatin1String(title)))
        << window->windowTitle().toStdString();
  };
  begins("thorax \xB7 CT, Thorax 1.0 B30f[*]");
  writeDescribed(folder.path() / "named", "1.2.3.5", "Quillon, thorax");
  ASSERT_TRUE(open(pathTo("named")));
  begins("named \xB7 CT[*]");
  window->findChild<QAction*>(QStringLiteral("patientInTitle"))->trigger();
  begins("named \xB7 CT, Quillon, thorax \xB7 ZEBEDEE, QUILLON");
}

TEST_F(TitleWindow, saysWhichSeriesOfAFolderIsOpen) {
  writeDescribed(folder.path() / "both", "1.2.3.5", "Thin");
  writeDescribed(folder.path() / "both", "1.2.3.6", "Thick");
  const auto list = openDicom(folder.path() / "both", {})->summaries();
  ASSERT_EQ(list.size(), 2u);
  for (const SeriesSummary& series : list) {
    SourceOptions options;
    options.read.series = series.number;
    window->openSource(pathTo("both"), options);
    ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
    EXPECT_TRUE(window->windowTitle().contains(QString::fromStdString("CT, " + series.description)))
        << window->windowTitle().toStdString();
  }
}

} // namespace
} // namespace limn
