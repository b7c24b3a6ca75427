// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Settings.h"

#include "widgets/view/InteractionQuality.h"

namespace limn {
namespace {

const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");
const QString recentKey = QStringLiteral("recent");
const QString themeKey = QStringLiteral("theme");
const QString refineKey = QStringLiteral("refineAtRest");
const QString patientKey = QStringLiteral("showPatient");
const QString movingKey = QStringLiteral("movingMs");
constexpr int mostRecent = 10;

} // namespace

QByteArray Settings::windowGeometry() const {
  return m_settings.value(geometryKey).toByteArray();
}

QByteArray Settings::windowState() const {
  return m_settings.value(stateKey).toByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
  m_settings.setValue(geometryKey, geometry);
  m_settings.setValue(stateKey, state);
}

QStringList Settings::recentSources() const {
  return m_settings.value(recentKey).toStringList();
}

void Settings::addRecentSource(const QString& source) {
  QStringList sources = recentSources();
  sources.removeAll(source);
  sources.prepend(source);
  m_settings.setValue(recentKey, sources.mid(0, mostRecent));
}

void Settings::removeRecentSource(const QString& source) {
  QStringList sources = recentSources();
  sources.removeAll(source);
  m_settings.setValue(recentKey, sources);
}

QString Settings::theme() const {
  return m_settings.value(themeKey, QStringLiteral("system")).toString();
}

void Settings::setTheme(const QString& theme) {
  m_settings.setValue(themeKey, theme);
}

double Settings::movingMs() const {
  const double ms = m_settings.value(movingKey, InteractionQuality::usualTargetMs).toDouble();
  return ms > 0.0 ? ms : InteractionQuality::usualTargetMs;
}

void Settings::setMovingMs(double ms) {
  m_settings.setValue(movingKey, ms);
}

bool Settings::refinesAtRest() const {
  return m_settings.value(refineKey, true).toBool();
}

void Settings::setRefinesAtRest(bool refines) {
  m_settings.setValue(refineKey, refines);
}

bool Settings::patientIsShown() const {
  return m_settings.value(patientKey, true).toBool();
}

void Settings::setPatientIsShown(bool shown) {
  m_settings.setValue(patientKey, shown);
}

} // namespace limn
