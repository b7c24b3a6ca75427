// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QWidget;

namespace limn {

class MessageBar;
class OpenDocument;
class Settings;

/// What the window is called. Whether that tells whom the volume shows is asked once, of the first one that
/// says so; until it is answered nobody is named.
class TitleDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Parts {
    const OpenDocument& document;
    Settings& settings;
    QAction& patientInTitle; ///< the answer, which can be changed
    MessageBar& question;
    QWidget& window;
  };
  explicit TitleDesk(const Parts& parts);

  /// After another volume or session is open.
  void show();

private:
  void choose(bool isShown);
  void ask();

  Parts m_parts;
};

} // namespace limn
