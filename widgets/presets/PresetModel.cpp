// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetModel.h"

#include "scene/presets/PresetFit.h"
#include "widgets/curve/picture/CanvasPicture.h"

#include <QObject>
#include <QPainter>
#include <QPainterPath>
#include <QStandardItemModel>

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

QStandardItem* groupItem(const QString& title) {
  auto* item = new QStandardItem(title);
  item->setData(true, presetRole::isGroup);
  item->setFlags(Qt::ItemIsEnabled);
  return item;
}

QStandardItem* presetItem(const ListedPreset& listed, const QImage& curve) {
  const QString name = QString::fromStdString(listed.preset.name);
  const QString shownName = presetWords(name);
  const QString note = presetWords(QString::fromStdString(listed.preset.note));
  const QString modality = QString::fromStdString(listed.preset.modality);
  const QString folder = QString::fromStdString(listed.preset.folder);
  auto* item = new QStandardItem(name);
  item->setData(false, presetRole::isGroup);
  item->setData(listed.isOwn, presetRole::isOwn);
  item->setData(listed.isFavourite, presetRole::isFavourite);
  item->setData(listed.standing, presetRole::standing);
  item->setData(listed.isOwn && note.isEmpty() ? modality : note, presetRole::note);
  item->setData(curve, presetRole::curve);
  item->setData(QStringList{name, shownName, modality, folder, note}.join(QLatin1Char(' ')),
                presetRole::searchText);
  item->setToolTip(
      note.isEmpty()
          ? shownName
          : QStringLiteral("<p><b>%1</b></p><p>%2</p>").arg(shownName.toHtmlEscaped(), note.toHtmlEscaped()));
  item->setStatusTip(note); // whole, however narrow the list is
  item->setEditable(false);
  return item;
}

template <class Work>
void forEachPreset(QStandardItemModel& model, Work work) {
  for (int group = 0; group < model.rowCount(); ++group)
    for (int row = 0; row < model.item(group)->rowCount(); ++row)
      work(*model.item(group)->child(row));
}

// What is seen of a row is heard, too.
void nameForScreenReaders(QStandardItem& item) {
  QStringList parts{presetWords(item.text())};
  if (item.data(presetRole::isFavourite).toBool())
    parts << QObject::tr("favourite", "a preset");
  const auto use = static_cast<PresetUse>(item.data(presetRole::use).toInt());
  if (use != PresetUse::none)
    parts << QObject::tr("shown", "a preset");
  if (use == PresetUse::modified)
    parts << QObject::tr("modified", "a preset");
  if (item.data(presetRole::showsNothing).toBool())
    parts << QObject::tr("shows nothing of this volume");
  item.setData(parts.join(QStringLiteral(", ")), Qt::AccessibleTextRole);
}

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
        groups.add(QObject::tr("Favourites"), {preset, areOwn, true, rankOf(preset, standing)});
  for (const Preset& preset : filed)
    if (!isFavourite(preset))
      groups.add(preset.folder.empty() ? QObject::tr("My presets") : QString::fromStdString(preset.folder),
                 {preset, true, false, rankOf(preset, standing)});
  for (const Preset& preset : ranked)
    if (!isFavourite(preset))
      groups.add(titleOf(preset, standing), {preset, false, false, rankOf(preset, standing)});
  return groups.all();
}

std::vector<std::string> foldersOf(const std::vector<Preset>& own) {
  std::set<std::string> folders;
  for (const Preset& preset : own)
    if (!preset.folder.empty())
      folders.insert(preset.folder);
  return {folders.begin(), folders.end()};
}

QString fittedWords(const QString& english) {
  return QObject::tr("%1, fitted", "a preset").arg(presetWords(english));
}

QImage curveThumbnail(const TransferFunction& function, const QSize& size, double devicePixelRatio,
                      Look look) {
  QImage image(size * devicePixelRatio, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(devicePixelRatio);
  image.fill(Qt::transparent);
  CanvasPicture picture;
  picture.colors = themeColors(look);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath frame;
  frame.addRoundedRect(QRectF(QPointF(0.0, 0.0), QSizeF(size)), 4.0, 4.0);
  painter.setClipPath(frame);
  painter.fillPath(frame, look == Look::light ? QColor("#2a2e33") : QColor("#101214"));
  if (function.points.empty())
    return image;

  const double first = function.points.front().value;
  const double last = function.points.back().value;
  const double margin = std::max(1e-9, 0.08 * (last - first));
  picture.function = function;
  picture.transform = {QRectF(0.0, 4.0, size.width(), size.height() - 11.0), {first - margin, last + margin}};
  const QRectF& plot = picture.transform.plot;
  QPolygonF area = curvePolygon(picture.transform, function);
  area << plot.bottomRight() << plot.bottomLeft();
  painter.setPen(Qt::NoPen);
  painter.setBrush(QBrush(colorRow(picture)));
  painter.setOpacity(0.85);
  painter.drawPolygon(area);
  painter.setOpacity(1.0);
  painter.drawImage(QRectF(0.0, size.height() - 5.0, size.width(), 5.0), colorRow(picture));
  return image;
}

void markPresetUse(QStandardItemModel& model, const QString& name, PresetUse use) {
  forEachPreset(model, [&](QStandardItem& item) {
    item.setData(static_cast<int>(item.text() == name ? use : PresetUse::none), presetRole::use);
    nameForScreenReaders(item);
  });
}

void showPresetPicture(QStandardItemModel& model, const QString& name, const PresetPicture& picture) {
  forEachPreset(model, [&](QStandardItem& item) {
    if (item.text() != name)
      return;
    item.setData(picture.image, presetRole::picture);
    item.setData(picture.showsNothing, presetRole::showsNothing);
    nameForScreenReaders(item);
  });
}

void fillPresetModel(QStandardItemModel& model, const std::vector<PresetGroup>& groups, Look look) {
  model.clear();
  for (const PresetGroup& group : groups) {
    QStandardItem* heading = groupItem(group.title);
    model.appendRow(heading);
    for (const ListedPreset& listed : group.presets)
      heading->appendRow(presetItem(listed, curveThumbnail(listed.preset.transferFunction,
                                                           {thumbnailWidth, thumbnailHeight}, 2.0, look)));
  }
}

} // namespace limn
