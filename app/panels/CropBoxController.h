// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;

namespace limn {

class CropSection;
struct WindowContext;

/// Shows the crop box in the picture while its action is checked, and while the crop section is used: on
/// while one goes from there to its handles in the view.
class CropBoxController : public QObject {
  Q_OBJECT

public:
  CropBoxController(WindowContext& context, const CropSection& section);

  bool isShown() const;
  void setShown(bool isShown);

private:
  void show();
  void followFocus(const QWidget* now);

  WindowContext& m_context;
  const CropSection& m_section;
  QAction* m_action;
  bool m_isEdited = false; ///< in its section, or in the view since
};

} // namespace limn
