// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;

namespace limn {

struct WindowContext;

/// What the window is called. Whether that tells whom the volume shows is asked once, of the first one that
/// says so; until it is answered nobody is named.
class TitleController : public QObject {
  Q_OBJECT

public:
  explicit TitleController(WindowContext& context);

  /// After another volume or session is open.
  void show();

private:
  void choose(bool isShown);
  void ask();

  WindowContext& m_context;
  QAction* m_patientInTitle; ///< the answer, which can be changed
};

} // namespace limn
