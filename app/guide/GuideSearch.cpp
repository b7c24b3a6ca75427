// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/GuideSearch.h"

#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace limn {
namespace {

// What says nothing of what is looked for.
const QStringList& questionWords() {
  static const QStringList words =
      QStringLiteral(
          "a about again all am an and any are at be been but by can cannot could did do does doing "
          "don for from get gets got had has have having how i if in instead into is isn it its "
          "just like limn look looks make many me much must my no not of on one or our please "
          "program shall should so some than that the their them then there these they this those "
          "to too use using very want was we were what when where which who why will with work "
          "works would you your")
          .split(QLatin1Char(' '));
  return words;
}

QStringList withoutQuestion(const QStringList& words) {
  QStringList telling;
  std::ranges::copy_if(words, std::back_inserter(telling), [](const QString& word) {
    return !questionWords().contains(word, Qt::CaseInsensitive);
  });
  return telling.isEmpty() ? words : telling;
}

// One thing under several names, in British and American spelling, by the beginnings that inflections share.
const QList<GuideWord>& oneThing() {
  static const QList<GuideWord> things = [] {
    QList<GuideWord> made;
    for (const char* names : {"film movie animat video turntable",
                              "grey gray",
                              "colour color",
                              "centre center",
                              "picture image screenshot photo render",
                              "dark black",
                              "empty blank invisible nothing",
                              "noisy noise grain",
                              "ring stripe band terrace grain",
                              "slow lag",
                              "delete remove erase hide",
                              "rotate turn",
                              "distance length",
                              "label segmentation mask",
                              "surface mesh stl",
                              "patient anonym",
                              "key shortcut hotkey",
                              "save export",
                              "mirror flip left",
                              "crop clip",
                              "undo revert"})
      made << QString::fromLatin1(names).split(QLatin1Char(' '));
    return made;
  }();
  return things;
}

// "films" is found where "film" stands.
QString withoutPlural(const QString& word) {
  constexpr qsizetype shortest = 4;
  const bool isPlural = word.size() > shortest && word.endsWith(QLatin1Char('s')) &&
                        !word.endsWith(QLatin1String("ss")) && !word.endsWith(QLatin1String("us"));
  return isPlural ? word.chopped(1) : word;
}

GuideWord wordOf(const QString& written) {
  GuideWord word{withoutPlural(written)};
  for (const GuideWord& thing : oneThing())
    if (std::ranges::any_of(thing, [&](const QString& name) { return word.front().startsWith(name); }))
      word << thing;
  word.removeDuplicates();
  return word;
}

} // namespace

QStringList tellingWordsOf(const QString& text) {
  static const QRegularExpression space(QStringLiteral("\\s+"));
  return withoutQuestion(text.split(space, Qt::SkipEmptyParts));
}

QList<GuideWord> guideWordsOf(const QString& text) {
  static const QRegularExpression between(QStringLiteral("(?:['’]s\\b|[\\s\\-?!.,;:'’\"])+"));
  QList<GuideWord> words;
  for (const QString& word : withoutQuestion(text.toLower().split(between, Qt::SkipEmptyParts)))
    words << wordOf(word);
  return words;
}

HeldName heldName(const QString& text, const GuideWord& word) {
  constexpr qsizetype shortName = 4; // "ring" is no part of "measuring"
  for (const QString& name : word)
    for (qsizetype at = text.indexOf(name, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(name, at + 1, Qt::CaseInsensitive))
      if (name.size() > shortName || at == 0 || !text[at - 1].isLetter())
        return {at, name.size()};
  return {};
}

bool tellsOf(const QString& piece, const QStringList& headings, const QList<GuideWord>& words) {
  const auto isHere = [&](const GuideWord& word) { return heldName(piece, word).at >= 0; };
  const auto isNamed = [&](const GuideWord& word) {
    return isHere(word) || std::ranges::any_of(headings, [&](const QString& heading) {
             return heldName(heading, word).at >= 0;
           });
  };
  return std::ranges::any_of(words, isHere) && std::ranges::all_of(words, isNamed);
}

} // namespace limn
