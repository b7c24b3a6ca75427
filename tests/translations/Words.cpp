// SPDX-License-Identifier: GPL-3.0-or-later
#include "translations/Words.h"

#include "support/Places.h"
#include "support/TemporaryFolder.h"

#include <QFile>
#include <QProcess>
#include <QXmlStreamReader>

#include <stdexcept>

namespace limn::test {
namespace {

Word readMessage(QXmlStreamReader& xml, const QString& context) {
  Word word{context, {}, {}, false};
  while (xml.readNextStartElement()) {
    if (xml.name() == QLatin1String("source")) {
      word.source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      word.isFinished = !xml.attributes().hasAttribute(QLatin1String("type"));
      word.translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    } else {
      xml.skipCurrentElement();
    }
  }
  return word;
}

void readContext(QXmlStreamReader& xml, std::vector<Word>& words) {
  QString context;
  while (xml.readNextStartElement()) {
    if (xml.name() == QLatin1String("name"))
      context = xml.readElementText();
    else if (xml.name() == QLatin1String("message"))
      words.push_back(readMessage(xml, context));
    else
      xml.skipCurrentElement();
  }
}

} // namespace

std::vector<Word> wordsIn(const std::filesystem::path& list) {
  QFile file(QString::fromStdString(list.string()));
  if (!file.open(QIODevice::ReadOnly))
    throw std::runtime_error("cannot open " + list.string());
  QXmlStreamReader xml(&file);
  std::vector<Word> words;
  xml.readNextStartElement();
  while (xml.readNextStartElement()) {
    if (xml.name() == QLatin1String("context"))
      readContext(xml, words);
    else
      xml.skipCurrentElement();
  }
  if (xml.hasError())
    throw std::runtime_error(list.string() + ": " + xml.errorString().toStdString());
  return words;
}

const std::vector<Word>& germanWords() {
  static const std::vector<Word> words = wordsIn(sourceFolder() / "app/translations/limn_de.ts");
  return words;
}

const Search& stringsOfTheSources() {
  static const Search search = [] {
    const TemporaryFolder folder;
    const std::filesystem::path list = folder.path() / "found_de.ts";
    QStringList command = QStringLiteral(LIMN_LUPDATE).split(QLatin1Char(' '));
    QProcess lupdate;
    lupdate.setWorkingDirectory(QString::fromStdString(sourceFolder().string()));
    lupdate.start(command.takeFirst(), command << QString::fromStdString(list.string()));
    if (!lupdate.waitForFinished(-1) || lupdate.exitCode() != 0)
      throw std::runtime_error("lupdate failed: " + lupdate.readAllStandardError().toStdString());
    return Search{wordsIn(list), QString::fromUtf8(lupdate.readAllStandardError())};
  }();
  return search;
}

std::string described(const Word& word) {
  return word.context.toStdString() + ": \"" + word.source.toStdString() + "\" -> \"" +
         word.translation.toStdString() + "\"";
}

} // namespace limn::test
