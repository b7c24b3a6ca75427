// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/LookImport.h"

#include "io/reading/ReadError.h"
#include "io/scenefile/SceneFile.h"
#include "widgets/Translated.h"

#include <QFileInfo>
#include <QObject>

#include <algorithm>
#include <map>

namespace limn {
namespace {

/// Whether a look is another one over another range of values.
bool isRelative(const std::string& text, const std::string& name) {
  const std::vector<ReadLook> low = parseLooks(text, name, LookTarget{0.0, 1.0, 1.0});
  const std::vector<ReadLook> high = parseLooks(text, name, LookTarget{1.0, 3.0, 1.0});
  return !std::ranges::equal(low, high, [](const ReadLook& a, const ReadLook& b) {
    return a.preset.transferFunction == b.preset.transferFunction;
  });
}

std::vector<ReadLook> looksIn(const QString& path, const std::optional<LookTarget>& target) {
  const std::string name = QFileInfo(path).fileName().toStdString();
  const std::string text = readTextFile(path.toStdString());
  if (!target && isRelative(text, name))
    failReading(name, Message::tr("its values are fractions of a volume's range"),
                Message::tr("open the volume that it is for, then import it again"));
  return parseLooks(text, name, target);
}

struct NamedRemarks {
  QString look;
  QStringList remarks;
};

/// Each remark on a file's looks once; one that is not on all of them names those that it is on.
QStringList remarksOnFile(const std::vector<NamedRemarks>& looks) {
  QStringList all, told;
  for (const NamedRemarks& look : looks)
    all << look.remarks;
  all.removeDuplicates();
  for (const QString& remark : all) {
    QStringList names;
    for (const NamedRemarks& look : looks)
      if (look.remarks.contains(remark))
        names << look.look;
    const bool isOnAll = names.size() == static_cast<qsizetype>(looks.size());
    told << (isOnAll ? remark : QObject::tr("%1: %2").arg(names.join(QObject::tr(", ")), remark));
  }
  return told;
}

/// Keeps looks beside the presets that there are.
class LookKeeper {
public:
  explicit LookKeeper(const PresetStore& store) : m_store(store) {
    for (Preset& preset : allPresets(store))
      m_presets.emplace(preset.name, std::move(preset));
  }

  /// Imports a file; `kept` receives the names of its presets.
  LookReportEntry keep(const QString& path, const std::optional<LookTarget>& target, QStringList& kept) {
    LookReportEntry entry{QFileInfo(path).fileName(), {}, {}, false};
    QStringList names, renamings, refusal;
    std::vector<NamedRemarks> looks;
    try {
      for (const ReadLook& look : looksIn(path, target)) {
        names << keepLook(look.preset, renamings);
        looks.push_back({names.back(), {}});
        for (const Message& change : look.changes)
          looks.back().remarks << translated(change);
      }
    } catch (const Error& error) {
      entry.isRefused = true;
      refusal << translated(error.sentence());
    }
    entry.sentences = remarksOnFile(looks) + renamings + refusal;
    entry.outcome = names.isEmpty() ? QObject::tr("not imported")
                                    : QObject::tr("imported as %1").arg(names.join(QObject::tr(", ")));
    kept << names;
    return entry;
  }

private:
  QString keepLook(Preset look, QStringList& sentences) {
    const std::string wanted = look.name;
    auto present = m_presets.find(look.name);
    for (int number = 2; present != m_presets.end() && present->second != look; ++number) {
      look.name = wanted + " " + std::to_string(number);
      present = m_presets.find(look.name);
    }
    if (present == m_presets.end()) {
      m_store.find(look.name); // a file that cannot be read is not replaced either: this throws
      m_store.save(look);
      m_presets.emplace(look.name, look);
    }
    if (look.name != wanted)
      sentences << QObject::tr("There is another preset \"%1\" already, so that this one is called \"%2\".")
                       .arg(QString::fromStdString(wanted), QString::fromStdString(look.name));
    return QString::fromStdString(look.name);
  }

  const PresetStore& m_store;
  std::map<std::string, Preset> m_presets; ///< by name
};

} // namespace

LookImport importLooks(const QStringList& paths, const std::optional<LookTarget>& target,
                       const PresetStore& store) {
  LookImport import;
  LookKeeper keeper(store);
  for (const QString& path : paths)
    import.files.push_back(keeper.keep(path, target, import.presets));
  return import;
}

} // namespace limn
