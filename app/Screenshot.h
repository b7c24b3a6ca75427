// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace limn {

class MainWindow;

/// Saves a picture of the whole window once its volume is loaded and drawn at full quality, then quits the
/// program: with status 0, 3 where loading failed, or 1 where saving did.
void saveScreenshotAtRest(MainWindow& window, const QString& path);

} // namespace limn
