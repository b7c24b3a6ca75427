// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace limn {

/// The place of the guide that speaks of the panel in which `focused` stands, such as "panels.presets"; the
/// first chapter where none does or it is null.
QString guidePlaceOf(const QWidget* focused);

} // namespace limn
