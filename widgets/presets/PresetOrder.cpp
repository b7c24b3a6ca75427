// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetOrder.h"

#include "scene/presets/PresetFit.h"

#include <QObject>

#include <algorithm>

namespace limn {
namespace {

QString modalityTitle(const std::string& modality) {
  if (modality == "PT")
    return QObject::tr("PET");
  if (modality == "US")
    return QObject::tr("Ultrasound");
  return modality.empty() ? QObject::tr("Any data") : QString::fromStdString(modality);
}

bool fits(const Preset& preset, const PresetStanding& standing) {
  return !standing.fit || standing.fit->isHounsfield || !isForHounsfield(preset);
}

// The smaller, the higher in the list.
int rankOf(const Preset& preset, const PresetStanding& standing) {
  if (!standing.fit)
    return 0;
  if (!fits(preset, standing))
    return 3;
  return preset.modality == standing.fit->modality ? 0 : preset.modality.empty() ? 1 : 2;
}

QString titleOf(const Preset& preset, const PresetStanding& standing) {
  const QString modality = modalityTitle(preset.modality);
  return fits(preset, standing) ? modality : QObject::tr("%1, for Hounsfield units").arg(modality);
}

// What a volume opens with tells its modality where its file does not.
PresetStanding withModality(PresetStanding standing, const std::vector<Preset>& builtIn) {
  if (standing.fit && standing.fit->modality.empty())
    for (const Preset& preset : builtIn)
      if (preset.name == standing.fit->firstLook)
        standing.fit->modality = preset.modality;
  return standing;
}

class Groups {
public:
  void add(const QString& title, const ListedPreset& preset) {
    auto found = std::ranges::find(m_groups, title, &PresetGroup::title);
    if (found == m_groups.end())
      found = m_groups.insert(m_groups.end(), {title, {}});
    found->presets.push_back(preset);
  }
  std::vector<PresetGroup> all() const { return m_groups; }

private:
  std::vector<PresetGroup> m_groups;
};

} // namespace

std::vector<PresetGroup> groupedPresets(const std::vector<Preset>& builtIn, const std::vector<Preset>& own,
                                        const PresetStanding& asked) {
  const PresetStanding standing = withModality(asked, builtIn);
  std::vector<Preset> ranked = builtIn;
  const auto isFirstLook = [&](const Preset& preset) {
    return standing.fit && preset.name == standing.fit->firstLook;
  };
  std::ranges::stable_sort(ranked, [&](const Preset& a, const Preset& b) {
    const int rank = rankOf(a, standing);
    const int other = rankOf(b, standing);
    return rank != other ? rank < other : isFirstLook(a) && !isFirstLook(b);
  });
  std::vector<Preset> filed = own;
  std::ranges::stable_sort(filed, {}, &Preset::folder);

  Groups groups;
  const auto isFavourite = [&](const Preset& preset) { return standing.favourites.contains(preset.name); };
  for (const auto& [presets, areOwn] : {std::pair(&filed, true), std::pair(&ranked, false)})
    for (const Preset& preset : *presets)
      if (isFavourite(preset))
        groups.add(QObject::tr("Favourites"), {preset, areOwn, true});
  for (const Preset& preset : filed)
    if (!isFavourite(preset))
      groups.add(preset.folder.empty() ? QObject::tr("My presets") : QString::fromStdString(preset.folder),
                 {preset, true, false});
  for (const Preset& preset : ranked)
    if (!isFavourite(preset))
      groups.add(titleOf(preset, standing), {preset, false, false});
  return groups.all();
}

std::vector<std::string> foldersOf(const std::vector<Preset>& own) {
  std::set<std::string> folders;
  for (const Preset& preset : own)
    if (!preset.folder.empty())
      folders.insert(preset.folder);
  return {folders.begin(), folders.end()};
}

} // namespace limn
