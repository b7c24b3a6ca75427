// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/privacy/Marks.h"

// Whether the title bar names the patient, in the window.

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

} // namespace
} // namespace limn
