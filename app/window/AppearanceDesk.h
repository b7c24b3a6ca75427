// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/Settings.h"
#include "app/actions/Actions.h"

#include <QObject>

class QStatusBar;

namespace limn {

/// How the window looks and which language it speaks: the choices in the settings, kept for the next time.
class AppearanceDesk : public QObject {
  Q_OBJECT

public:
  /// Shows what is chosen in the actions.
  AppearanceDesk(Settings& settings, const Actions& actions, QStatusBar& status, QObject* parent);
};

} // namespace limn
