// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/presets/PresetStore.h"

#include <QObject>

#include <functional>
#include <vector>

class QString;

namespace limn {

struct WindowContext;

/// The user's own presets: keeps what is shown as one, and names, files, copies and deletes them. What is
/// deleted or replaced is brought back by one click.
class OwnPresetController : public QObject {
  Q_OBJECT

public:
  explicit OwnPresetController(WindowContext& context);

  /// As they were read last.
  const std::vector<Preset>& presets() const { return m_presets; }
  /// One of them; null where none has this name. The next reading ends it.
  const Preset* find(const QString& name) const;

  /// Reads them from their folder, and says which could not be read.
  void read();
  /// The same, but only where the file of this one has been edited since.
  void readEdited(const QString& name);

  /// Asks for a name and keeps what is shown under it.
  void askForName();
  /// Asks for the name under which a preset, as fitted to what is open, is kept.
  void duplicate(const Preset& preset);

  // Nothing happens where none has the name.

  void remove(const QString& name);
  /// Asks for another name.
  void rename(const QString& name);
  /// Asks for the note.
  void editNote(const QString& name);
  /// Puts one into a folder of the list; an empty one is none.
  void moveTo(const QString& name, const QString& folder);
  /// Asks for the folder.
  void moveToNewFolder(const QString& name);

signals:
  void listed();                  ///< they were read anew
  void kept(const QString& name); ///< under this name, and listed

private:
  void ask(const QString& title, const QString& label, const QString& name,
           const std::function<void(const QString&)>& answer,
           const std::function<QString(const QString&)>& refusal = {});
  QString refusal(const QString& name) const;
  bool mayReplace(const QString& question);
  void keepCopy(Preset copy, const QString& name);
  void save(const QString& name);
  void change(const QString& name, const std::function<void(Preset&)>& edit);
  void offerBack(const Preset& preset, const QString& sentence, const QString& label, bool isFavourite);

  WindowContext& m_context;
  PresetStore m_store;
  std::vector<Preset> m_presets;
};

} // namespace limn
