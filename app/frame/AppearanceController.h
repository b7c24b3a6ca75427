// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace limn {

struct WindowContext;

/// How the window looks and which language it speaks: the choices in the settings, kept for the next time.
class AppearanceController : public QObject {
  Q_OBJECT

public:
  explicit AppearanceController(WindowContext& context);

private:
  void addThemes();
  void addLanguages();

  WindowContext& m_context;
};

} // namespace limn
