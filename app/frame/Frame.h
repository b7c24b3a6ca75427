// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/frame/AppearanceController.h"
#include "app/frame/FocusMode.h"
#include "app/frame/PanelCycle.h"
#include "app/frame/TitleController.h"
#include "app/frame/TourController.h"
#include "app/frame/dialogs/DialogController.h"

namespace limn {

/// What belongs to the window itself, whatever is open: its title, theme and language, the keys that lead
/// through it, its settings, help and tour. It is made last, and gives menus and docks their places.
class Frame : public QObject {
  Q_OBJECT

public:
  explicit Frame(WindowContext& context);

  TitleController& title() { return m_title; }
  TourController& tour() { return m_tour; }
  FocusMode& focusMode() { return m_focus; }

private:
  AppearanceController m_appearance;
  FocusMode m_focus;
  PanelCycle m_panels;
  TitleController m_title;
  DialogController m_dialogs;
  TourController m_tour;
};

} // namespace limn
