// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QStringList>

namespace limn {

/// What the program remembers between runs: window, theme, recent files. Nothing about patients.
class Settings {
public:
  QByteArray windowGeometry() const;
  QByteArray windowState() const;
  void setWindow(const QByteArray& geometry, const QByteArray& state);

  /// Most recent first, at most ten.
  QStringList recentSources() const;
  void addRecentSource(const QString& source);
  void removeRecentSource(const QString& source);

  /// "system", "light" or "dark".
  QString theme() const;
  void setTheme(const QString& theme);

  /// The drawing time of a picture aimed at while something moves, ms; 40 at first.
  double movingMs() const;
  void setMovingMs(double ms);

  /// Whether resting pictures go on to smaller steps; true at first.
  bool refinesAtRest() const;
  void setRefinesAtRest(bool refines);

  bool patientIsShown() const;
  void setPatientIsShown(bool shown);

private:
  QSettings m_settings;
};

} // namespace limn
