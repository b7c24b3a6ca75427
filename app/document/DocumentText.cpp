// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/DocumentText.h"

#include "app/document/OpenDocument.h"
#include "app/document/PrivateNames.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <optional>
#include <vector>

namespace limn {
namespace {

const QString sample = QStringLiteral("sample");

// The series of DICOM that is open, the first of its folder where none was asked for.
std::optional<SeriesSummary> openSeries(const OpenDocument& document) {
  const SourceOptions& options = document.request().options;
  if (!options.dicom)
    return std::nullopt;
  const std::vector<SeriesSummary> all = options.dicom->summaries();
  const auto found = std::ranges::find(all, options.read.series.value_or(1), &SeriesSummary::number);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

// "CT, Thorax 1.0". Descriptions are typed by people, also with the patient's name.
QString seriesText(const OpenDocument& document, bool showsPatient) {
  const std::optional<SeriesSummary> series = openSeries(document);
  if (!series)
    return {};
  QStringList words{QString::fromStdString(series->modality)};
  const QString description = QString::fromStdString(series->description).simplified();
  if (showsPatient || !mayNameThePatient(description, document.scene().volume->info().patient))
    words << description;
  words.removeAll(QString());
  return words.join(QStringLiteral(", "));
}

// The volume's name, behind the session's where it has a file.
QString nameShown(const OpenDocument& document, bool showsPatient) {
  const Volume& volume = *document.scene().volume;
  const QString path = QString::fromStdString(document.volumePath());
  QString name = document.request().source == sample ? QObject::tr("Sample head")
                 : showsPatient                      ? QFileInfo(path).fileName()
                                                     : shareableName(path, volume);
  const QString session = QFileInfo(document.sessionFile()).fileName();
  if (!session.isEmpty() && (showsPatient || !mayNameThePatient(session, volume.info().patient)))
    name.prepend(session + QStringLiteral(" · "));
  return name;
}

} // namespace

QString momentText(const QDateTime& moment) {
  return QLocale().toString(moment.toLocalTime(), QObject::tr("d MMM yyyy, HH:mm", "as Qt formats dates"));
}

QString titleOf(const OpenDocument& document, bool showsPatient) {
  const QString program = QObject::tr("Limn · not for diagnosis");
  const auto& volume = document.scene().volume;
  if (!volume)
    return program + QStringLiteral("[*]");
  QString what = nameShown(document, showsPatient);
  if (const QString series = seriesText(document, showsPatient); !series.isEmpty())
    what += QStringLiteral(" · ") + series;
  const PatientLabel& patient = volume->info().patient;
  if (showsPatient)
    for (const std::string& part : {patient.name, patient.id, patient.studyDate})
      if (!part.empty())
        what += QStringLiteral(" · ") + QString::fromStdString(part);
  return what.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]")) + QStringLiteral("[*] — ") + program;
}

QString labelOf(const OpenDocument& document) {
  return labelOf(document, document.request().source);
}

QString labelOf(const OpenDocument& document, const QString& file) {
  if (file == sample)
    return QObject::tr("Sample head");
  const Volume& volume = *document.scene().volume;
  const QString name = QFileInfo(file).fileName();
  if (name.isEmpty() || mayNameThePatient(name, volume.info().patient))
    return plainDescription(volume);
  return name + QStringLiteral(" · ") + plainDescription(volume);
}

QString labelOfVolume(const OpenDocument& document) {
  const QString& asked = document.request().source;
  return labelOf(document, asked == sample ? asked : QString::fromStdString(document.volumePath()));
}

QString suggestedName(const OpenDocument& document) {
  const auto& volume = document.scene().volume;
  if (!volume || document.volumePath().empty())
    return QStringLiteral("limn");
  const QString name = shareableName(QString::fromStdString(document.volumePath()), *volume);
  return QFileInfo(name).baseName();
}

QString volumeText(const Volume& volume) {
  const Grid& grid = volume.grid();
  const auto number = [](double value) { return digitsNumber(value, 5); };
  return QObject::tr("%1×%2×%3 · %4×%5×%6 mm · %7 to %8 %9")
      .arg(grid.dims.x)
      .arg(grid.dims.y)
      .arg(grid.dims.z)
      .arg(digitsNumber(grid.spacingMm.x, 3))
      .arg(digitsNumber(grid.spacingMm.y, 3))
      .arg(digitsNumber(grid.spacingMm.z, 3))
      .arg(number(volume.range().lowest), number(volume.range().highest))
      .arg(QString::fromStdString(volume.info().unit));
}

QStringList remarksOn(const Volume& volume, const std::vector<Message>& notes) {
  // Voxels that are not those of the scanner come first: only the first of all is seen unasked.
  std::vector<Message> said = volume.info().warnings;
  said.insert(said.begin() + (volume.info().slants ? 1 : 0), notes.begin(), notes.end());
  QStringList remarks;
  for (const Message& remark : said)
    remarks << translated(remark);
  if (const std::size_t invalid = volume.invalidVoxels(); invalid > 0)
    remarks << (invalid == 1 ? QObject::tr("%L1 voxel holds no data and is shown as the smallest value.")
                             : QObject::tr("%L1 voxels hold no data and are shown as the smallest value."))
                   .arg(invalid);
  return remarks;
}

} // namespace limn
