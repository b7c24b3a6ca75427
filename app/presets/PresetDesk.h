// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/presets/PresetStore.h"

#include <QObject>

class QWidget;

namespace limn {

class MessageBar;
class OpenDocument;
class PresetBrowser;
class SaveNotes;
class Session;

/// Uses presets in a session, built-in ones and the user's own, and keeps the latter.
class PresetDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Partners {
    Session& session;
    OpenDocument& document;
    PresetBrowser& browser; ///< lists the presets and marks the one in use
    MessageBar& messages;
    SaveNotes& notes;
    QWidget& window; ///< over which is asked
  };

  PresetDesk(PresetStore store, const Partners& partners);

  /// Lists the presets anew.
  void refresh();
  /// Marks the preset whose curves are shown.
  void markShown();

  void use(const QString& name);
  /// The preset of this number (from 1 on) in the list; 0 is the full range of values.
  void useNumber(int number);

  /// Asks for a name and saves the scene as a preset.
  void askForName();
  void remove(const QString& name);

private:
  void show(const Preset& preset, const QString& edit);
  void offerToFit(const Preset& preset);
  void save(const QString& name);

  PresetStore m_store;
  Partners m_with;
};

} // namespace limn
