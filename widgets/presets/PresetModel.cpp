// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetModel.h"

#include "widgets/curve/picture/CanvasPicture.h"

#include <QObject>
#include <QPainter>
#include <QPainterPath>
#include <QStandardItemModel>

#include <algorithm>

namespace limn {
namespace {

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
