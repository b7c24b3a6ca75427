// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

namespace limn {

/// A built-in preset's name or note in the window's language (translations/PresetWords.cpp); what users have
/// written stays. Presets are known by their English names everywhere but on the screen.
inline QString presetWords(const QString& english) {
  return QCoreApplication::translate("limn::Preset", english.toUtf8().constData());
}

} // namespace limn
