// SPDX-License-Identifier: GPL-3.0-or-later
#include "translations/Words.h"

#include "support/FileBytes.h"
#include "support/Places.h"

#include <QRegularExpression>
#include <QSet>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <functional>

// Whether the window has every word in German, and whether each German text holds what its English one does.
// What fails here is mended by `./dev translate` and app/translations/README.md.
namespace limn::test {
namespace {

using Key = std::pair<QString, QString>;

QSet<Key> keysOf(const std::vector<Word>& words) {
  QSet<Key> keys;
  for (const Word& word : words)
    keys.insert({word.context, word.source});
  return keys;
}

QStringList matchesOf(const QString& text, const char* pattern) {
  QStringList found;
  auto matches = QRegularExpression(QLatin1String(pattern)).globalMatch(text);
  while (matches.hasNext())
    found << matches.next().captured();
  found.sort();
  return found;
}

// Calls `check` for each German text that somebody has translated.
void forEachTranslated(const std::function<void(const Word&)>& check) {
  ASSERT_GT(germanWords().size(), 900u) << "the list was not read";
  for (const Word& word : germanWords())
    if (word.isFinished)
      check(word);
}

// A string is looked for in the context of the class that says tr; where lupdate takes it for another, it is
// not found.
TEST(Words, lupdateListsStringsInTheContextsInWhichTheyAreLookedFor) {
  QSet<QString> contexts;
  for (const Word& word : stringsOfTheSources().found)
    contexts.insert(word.context);
  for (const QString& context : contexts)
    EXPECT_TRUE(context.startsWith(QLatin1String("limn::")) || context == QLatin1String("QObject") ||
                context == QLatin1String("Tissue") || context == QLatin1String("Message"))
        << context.toStdString() << "; lupdate says:\n"
        << stringsOfTheSources().complaints.toStdString();
}

TEST(Words, thoseOfPresetsAreThoseOfTheirFiles) {
  QSet<QString> listed, inFiles;
  for (const Word& word : stringsOfTheSources().found)
    if (word.context == QLatin1String("limn::Preset"))
      listed.insert(word.source);
  for (const auto& entry : std::filesystem::directory_iterator(sourceFolder() / "app/core/sources/presets")) {
    if (entry.path().extension() != ".json")
      continue;
    const nlohmann::json preset = nlohmann::json::parse(bytesOfFile(entry.path()));
    for (const char* key : {"name", "note"})
      inFiles.insert(QString::fromStdString(preset.at(key).get<std::string>()));
  }
  EXPECT_GT(inFiles.size(), 50);
  for (const QString& text : inFiles)
    EXPECT_TRUE(listed.contains(text))
        << "missing in app/translations/PresetWords.cpp: " << text.toStdString();
  for (const QString& text : listed)
    EXPECT_TRUE(inFiles.contains(text)) << "in no preset any more: " << text.toStdString();
}

TEST(Words, everyStringOfTheSourcesIsThereInGerman) {
  ASSERT_GT(stringsOfTheSources().found.size(), 900u) << "the sources were not searched";
  const QSet<Key> listed = keysOf(germanWords());
  for (const Word& word : stringsOfTheSources().found)
    EXPECT_TRUE(listed.contains({word.context, word.source})) << "missing: " << described(word);
  for (const Word& word : germanWords())
    EXPECT_TRUE(word.isFinished && !word.translation.isEmpty()) << "not translated: " << described(word);
}

TEST(Words, noStringIsListedThatTheSourcesNoLongerHave) {
  const QSet<Key> found = keysOf(stringsOfTheSources().found);
  for (const Word& word : germanWords())
    EXPECT_TRUE(found.contains({word.context, word.source})) << described(word);
}

TEST(Words, placesAreThoseOfTheEnglishText) {
  forEachTranslated([](const Word& word) {
    EXPECT_EQ(matchesOf(word.source, "%L?[1-9]|%n"), matchesOf(word.translation, "%L?[1-9]|%n"))
        << described(word);
    EXPECT_EQ(matchesOf(word.source, "</?[a-z0-9]+>"), matchesOf(word.translation, "</?[a-z0-9]+>"))
        << described(word);
  });
}

TEST(Words, mnemonicsEllipsesAndSpacesAtTheEndsAgree) {
  forEachTranslated([](const Word& word) {
    EXPECT_EQ(word.source.count(QLatin1Char('&')), word.translation.count(QLatin1Char('&')))
        << described(word);
    EXPECT_EQ(word.source.endsWith(QChar(0x2026)), word.translation.endsWith(QChar(0x2026)))
        << described(word);
    EXPECT_EQ(word.source.back().isSpace(), word.translation.back().isSpace()) << described(word);
    EXPECT_EQ(word.source.front().isSpace(), word.translation.front().isSpace()) << described(word);
    const auto endsSentence = [](const QString& text) { return text.endsWith(QLatin1Char('.')); };
    EXPECT_EQ(endsSentence(word.source), endsSentence(word.translation)) << described(word);
  });
}

// Rules of app/translations/README.md that a program can look at.
TEST(Words, germanTextIsSetAsGermanIs) {
  forEachTranslated([](const Word& word) {
    EXPECT_FALSE(word.translation.contains(QLatin1Char('"'))) << "quotes are „…“: " << described(word);
    EXPECT_FALSE(word.translation.contains(QLatin1String("...")))
        << "the ellipsis is one letter: " << described(word);
    EXPECT_EQ(word.translation.count(QChar(0x201e)), word.translation.count(QChar(0x201c)))
        << described(word);
    EXPECT_TRUE(matchesOf(word.translation, "[%0-9] (mm|ms|s|MB|GiB|HU|%)(?![\\w=])").isEmpty())
        << "no line breaks between a number and its unit: " << described(word);
  });
}

} // namespace
} // namespace limn::test
