// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;

namespace limn {

class CompareView;
class CropSection;

/// Shows the crop box in the picture while its action is checked, and while the crop section is used: on
/// while one goes from there to its handles in the view.
class CropBoxDesk : public QObject {
public:
  CropBoxDesk(CompareView& view, const CropSection& section, QAction& action);

private:
  void show();
  void followFocus(const QWidget* now);

  CompareView& m_view;
  const CropSection& m_section;
  const QAction& m_action;
  bool m_isEdited = false; ///< in its section, or in the view since
};

} // namespace limn
