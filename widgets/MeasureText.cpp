// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/MeasureText.h"

#include "widgets/ValueText.h"

#include <QObject>
#include <QStringList>

#include <cmath>
#include <type_traits>
#include <variant>

namespace limn {
namespace {

constexpr qsizetype mostLetters = 40; // of a name in a sentence

QString cutName(const QString& name) {
  return name.size() <= mostLetters ? name : name.left(mostLetters - 1).trimmed() + QChar(0x2026);
}

QString givenName(const Measured& measured) {
  return QString::fromStdString(measured.measurement.name);
}

// Digits that count are written: 60.0 beside 81.9.
QString lengthText(double mm, const Volume& volume) {
  return withUnit(fixedNumber(mm, 1), volume.info().spacingKnown ? QObject::tr("mm") : QObject::tr("voxels"));
}

QString areaText(double mm2, const Volume& volume) {
  return withUnit(fixedNumber(mm2, mm2 < 100.0 ? 1 : 0),
                  volume.info().spacingKnown ? QObject::tr("mm²") : QObject::tr("voxels²"));
}

int decimalsIn(const Volume& volume) {
  return decimalsOfSpan(volume.range().highest - volume.range().lowest);
}

QString unitIn(const Volume& volume) {
  return QString::fromStdString(volume.info().unit);
}

QString ellipseText(const EllipseFigures& figures, const Volume& volume) {
  return QStringLiteral("%1 · %2").arg(figures.voxels > 0
                                           ? meanText(figures.mean, figures.deviation, figures.voxels, volume)
                                           : QObject::tr("no voxels"),
                                       areaText(figures.areaMm2, volume));
}

} // namespace

double valueStep(const Volume& volume) {
  const auto isOfIntegers = [](const auto& stored) {
    return std::is_integral_v<std::decay_t<decltype(*stored.begin())>>;
  };
  const double slope = std::abs(volume.rescale().slope);
  return std::visit(isOfIntegers, volume.stored()) && slope > 0.0 ? slope
                                                                  : std::pow(10.0, -decimalsIn(volume));
}

QString meanText(double mean, double deviation, std::size_t voxels, const Volume& volume) {
  const int decimals = decimalsOfMean(valueStep(volume), deviation, voxels);
  const QString unit = unitIn(volume);
  const QString scatter = fixedNumber(deviation, decimals);
  return QObject::tr("%1 ± %2").arg(fixedNumber(mean, decimals),
                                    unit.isEmpty() ? scatter : scatter + QChar(0x00a0) + unit);
}

bool isSeenInPicture(const Measurement& measurement) {
  return measurement.isShown && measurement.kind != Measurement::Kind::ellipse;
}

QString measureKindText(Measurement::Kind kind) {
  switch (kind) {
  case Measurement::Kind::distance:
    return QObject::tr("Distance");
  case Measurement::Kind::angle:
    return QObject::tr("Angle");
  case Measurement::Kind::ellipse:
    return QObject::tr("Ellipse");
  case Measurement::Kind::mark:
    return QObject::tr("Mark");
  }
  return {};
}

QString measureValueText(const Measured& measured, const Volume& volume) {
  switch (measured.measurement.kind) {
  case Measurement::Kind::distance:
    return lengthText(lengthMm(measured.measurement), volume);
  case Measurement::Kind::angle: {
    const std::optional<double> degrees = angleDegrees(measured.measurement);
    return degrees ? fixedNumber(*degrees, 1) + QChar(0x00b0) : QObject::tr("no angle: two places are one");
  }
  case Measurement::Kind::ellipse:
    return ellipseText(measured.ellipse, volume);
  case Measurement::Kind::mark:
    break;
  }
  return {};
}

QString measureNoteText(const Measured& measured, const Volume& volume) {
  const QString name = cutName(givenName(measured));
  const Measurement& one = measured.measurement;
  const bool isNothingYet = (one.kind == Measurement::Kind::angle && !angleDegrees(one)) ||
                            (one.kind == Measurement::Kind::distance && lengthMm(one) == 0.0);
  const QString value = isNothingYet ? QString() : measureValueText(measured, volume);
  return name.isEmpty() ? value : value.isEmpty() ? name : QStringLiteral("%1 · %2").arg(value, name);
}

QString measureTitle(const Measured& measured, const Volume& volume) {
  const QString kind = measureKindText(measured.measurement.kind);
  const QString note = measureNoteText(measured, volume);
  return note.isEmpty() ? kind : QStringLiteral("%1 %2").arg(kind, note);
}

MeasurementsEdited withoutMeasure(const std::vector<Measured>& measured, std::size_t number,
                                  const Volume& volume) {
  std::vector<Measurement> others = measurementsOf(measured);
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(number));
  return {std::move(others),
          std::nullopt,
          {nextGestureId(), QObject::tr("delete: %1").arg(measureTitle(measured[number], volume))}};
}

QString measureDetails(const Measured& measured, const Volume& volume) {
  QStringList lines{measureKindText(measured.measurement.kind)};
  for (const QString& line : {givenName(measured), measureValueText(measured, volume)})
    if (!line.isEmpty())
      lines << line;
  const EllipseFigures& figures = measured.ellipse;
  if (measured.measurement.kind == Measurement::Kind::ellipse && figures.voxels > 0) {
    const int decimals = decimalsIn(volume);
    lines << (figures.voxels == 1 ? QObject::tr("mean ± standard deviation of %1 voxel")
                                  : QObject::tr("mean ± standard deviation of %1 voxels"))
                 .arg(figures.voxels)
          << QObject::tr("from %1 to %2")
                 .arg(valueText(figures.lowest, {}, decimals),
                      valueText(figures.highest, unitIn(volume), decimals));
  }
  return lines.join(QLatin1Char('\n'));
}

} // namespace limn
