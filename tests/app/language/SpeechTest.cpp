// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language/InGerman.h"
#include "scene/basics/Error.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/controls/NumberField.h"

#include <QTest>

#include <gtest/gtest.h>

#include <clocale>

// Which language is spoken, and how a message and a number are said in it.
namespace limn::test {
namespace {

QString spoken(const char* asked, const char* system) {
  const Speech speech = speechFor(QLatin1String(asked), QLocale(QLatin1String(system)));
  return speech.code + QLatin1Char(' ') + speech.locale.name();
}

TEST(Speech, followsTheSystemUnlessAnotherIsAskedFor) {
  EXPECT_EQ(spoken("system", "de_AT"), "de de_AT");
  EXPECT_EQ(spoken("system", "en_GB"), "en en_GB");
  EXPECT_EQ(spoken("system", "fr_FR"), "en fr_FR") << "numbers are the user's, whatever the words";
  EXPECT_EQ(spoken("de", "de_CH"), "de de_CH");
  EXPECT_EQ(spoken("de", "en_US"), "de de_DE");
  EXPECT_EQ(spoken("en", "de_DE"), "en en_US");
  EXPECT_EQ(spoken("xx", "de_DE"), "de de_DE") << "what settings of another version may say";
}

TEST(Speech, saysMessagesWithTheirPartsInGerman) {
  const Message message = Message::tr("its voxels need %1 GiB of memory and this computer has %2")
                              .arg(Message::fixed(12.5, 1))
                              .arg(Message::rounded(8.0, 3));
  EXPECT_EQ(message.english(), "its voxels need 12.5 GiB of memory and this computer has 8");
  const Error error(Error::Kind::input, Message::tr("Cannot read %1: %2").arg("50%1.nii").arg(message));
  EXPECT_STREQ(error.what(),
               "Cannot read 50%1.nii: its voxels need 12.5 GiB of memory and this computer has 8");
  EXPECT_EQ(translated(error), QString::fromStdString(error.what())) << "in English";
  const InGerman german;
  EXPECT_EQ(translated(error),
            QStringLiteral("50%1.nii kann nicht gelesen werden: ihre Voxel brauchen 12,5\u00a0GiB "
                           "Speicher, und dieser Rechner hat 8"));
  EXPECT_EQ(translated(Message("a name")), "a name");
}

TEST(Speech, aNounWithinASentenceKeepsItsCapitalInGermanAlone) {
  EXPECT_EQ(inSentence(QStringLiteral("Highlights (ks)")), QStringLiteral("highlights (ks)"));
  EXPECT_EQ(inSentence(QStringLiteral("SP of highlights")), QStringLiteral("SP of highlights"))
      << "an acronym";
  const InGerman german;
  EXPECT_EQ(inSentence(QStringLiteral("Glanzlichter (ks)")), QStringLiteral("Glanzlichter (ks)"));
}

TEST(Speech, writesNumbersWithACommaAndReadsBoth) {
  const InGerman german;
  EXPECT_EQ(plainNumber(1234.5, 2), "1234,5");
  EXPECT_EQ(fixedNumber(0.25, 3), "0,250");
  EXPECT_EQ(valueText(-310.5, QStringLiteral("HU"), 1), QStringLiteral("−310,5\u00a0HU"));
  EXPECT_EQ(numberList({0.5, 0.5, 1.2}), "0,5; 0,5; 1,2");
  for (const char* typed : {"0.5", "0,5"}) {
    NumberField field(0.0, 1.0, 3);
    field.selectAll();
    QTest::keyClicks(&field, QLatin1String(typed));
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(field.number(), 0.5) << typed;
    EXPECT_EQ(field.text(), "0,5") << typed;
  }
  EXPECT_STREQ(std::localeconv()->decimal_point, ".") << "what printf writes goes into files";
}

TEST(Speech, listsOfNumbersAreReadAsTyped) {
  using Numbers = std::vector<double>;
  for (const char* typed : {"0.5, 0.5, 1.2", "0.5,0.5,1.2", "0,5; 0,5; 1,2", "0,5 0,5 1,2", " 0.5;0.5;1.2 "})
    EXPECT_EQ(numbersTyped(QLatin1String(typed)), Numbers({0.5, 0.5, 1.2})) << typed;
  EXPECT_FALSE(numbersTyped(QStringLiteral("0.5, wide, 1.2")));
}

TEST(Speech, aLanguageThatItDoesNotSpeakIsRefused) {
  const TemporaryFolder home;
  const Outcome run = runProgram(home.path(), "--language fr");
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_NE(run.err.find("--language"), std::string::npos) << run.err;
}

} // namespace
} // namespace limn::test
