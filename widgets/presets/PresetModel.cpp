// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetModel.h"

#include "widgets/Theme.h"
#include "widgets/curve/plot/CanvasPicture.h"
#include "widgets/presets/PresetWords.h"

#include <QObject>
#include <QPainter>
#include <QPainterPath>
#include <QStandardItemModel>

#include <algorithm>

namespace limn {
namespace {

QString groupTitle(const QString& modality) {
  if (modality == QStringLiteral("PT"))
    return QObject::tr("PET");
  if (modality == QStringLiteral("US"))
    return QObject::tr("Ultrasound");
  return modality.isEmpty() ? QObject::tr("Any data") : modality;
}

QStandardItem* groupItem(QStandardItemModel& model, const QString& title) {
  for (int row = 0; row < model.rowCount(); ++row)
    if (model.item(row)->text() == title)
      return model.item(row);
  auto* item = new QStandardItem(title);
  item->setData(true, presetRole::isGroup);
  item->setFlags(Qt::ItemIsEnabled);
  model.appendRow(item);
  return item;
}

QStandardItem* presetItem(const Preset& preset, bool own, const QImage& picture) {
  const QString name = QString::fromStdString(preset.name);
  const QString shownName = presetWords(name);
  const QString note = presetWords(QString::fromStdString(preset.note));
  const QString modality = QString::fromStdString(preset.modality);
  auto* item = new QStandardItem(name);
  item->setData(false, presetRole::isGroup);
  item->setData(own, presetRole::isOwn);
  item->setData(own && note.isEmpty() ? modality : note, presetRole::note);
  item->setData(picture, presetRole::thumbnail);
  item->setData(QStringList{name, shownName, modality, note}.join(QLatin1Char(' ')), presetRole::searchText);
  item->setToolTip(
      note.isEmpty()
          ? shownName
          : QStringLiteral("<p><b>%1</b></p><p>%2</p>").arg(shownName.toHtmlEscaped(), note.toHtmlEscaped()));
  item->setStatusTip(note); // whole, however narrow the list is
  item->setEditable(false);
  return item;
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
  picture.transform = {
      QRectF(0.0, 4.0, size.width(), size.height() - 11.0), {first - margin, last + margin}, false};
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
  for (int group = 0; group < model.rowCount(); ++group)
    for (int row = 0; row < model.item(group)->rowCount(); ++row) {
      QStandardItem* item = model.item(group)->child(row);
      const PresetUse its = item->text() == name ? use : PresetUse::none;
      item->setData(static_cast<int>(its), presetRole::use);
      item->setData(its == PresetUse::shown ? QObject::tr("%1, shown").arg(presetWords(item->text()))
                    : its == PresetUse::modified
                        ? QObject::tr("%1, shown, modified").arg(presetWords(item->text()))
                        : presetWords(item->text()),
                    Qt::AccessibleTextRole);
    }
}

void fillPresetModel(QStandardItemModel& model, const std::vector<Preset>& builtIn,
                     const std::vector<Preset>& own, Look look) {
  model.clear();
  const auto add = [&](const Preset& preset, bool isOwn, const QString& group) {
    const QSize size(thumbnailWidth, thumbnailHeight);
    const QImage picture = curveThumbnail(preset.transferFunction, size, 2.0, look);
    groupItem(model, group)->appendRow(presetItem(preset, isOwn, picture));
  };
  for (const Preset& preset : own)
    add(preset, true, QObject::tr("My presets"));
  for (const Preset& preset : builtIn)
    add(preset, false, groupTitle(QString::fromStdString(preset.modality)));
}

} // namespace limn
