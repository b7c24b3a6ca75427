// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/CropSection.h"

#include "scene/framing/VisibleVoxels.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/properties/CropFaces.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <optional>

namespace limn {
namespace {

// Of the whole volume along one of its axes; none where the file does not say.
std::optional<double> axisLengthMm(const Volume* volume, int axis) {
  if (!volume || !volume->info().spacingKnown)
    return std::nullopt;
  const Grid& grid = volume->grid();
  return grid.dims[axis] * grid.spacingMm[axis];
}

// Along an axis that is so long, where that is known.
NumberSpec percentSpec(const AxisName& name, const std::optional<double>& length) {
  const QString help = CropSection::tr(
      "What lies outside this part of the volume is cut away; the first number is the end named first.");
  return {.label = name.axis,
          .called = CropSection::tr("Crop of %1").arg(name.axis),
          .help = length ? CropSection::tr("%1 Millimetres from that end can be typed, too: 48 mm.").arg(help)
                         : help,
          .unit = QStringLiteral("%"),
          .otherUnit = length ? OtherUnit{QStringLiteral("mm"), 100.0 / *length} : OtherUnit{},
          .scale = {0.0, 100.0, false},
          .defaultUpper = 100.0,
          .decimals = 1,
          .lowerName = name.lowEnd,
          .upperName = name.highEnd};
}

QString extentText(const CropBox& crop, const Volume& volume, int axis) {
  const Grid& grid = volume.grid();
  const VoxelSpan span = voxelsInside(crop, grid, axis);
  const QString stacked = axis == 0   ? CropSection::tr("Columns %1–%2 of %3")
                          : axis == 1 ? CropSection::tr("Rows %1–%2 of %3")
                                      : CropSection::tr("Slices %1–%2 of %3");
  QString text = stacked.arg(span.first).arg(span.last).arg(grid.dims[axis]);
  if (const std::optional<double> length = axisLengthMm(&volume, axis))
    text += CropSection::tr(" · %1 mm").arg(plainNumber((crop.upper[axis] - crop.lower[axis]) * *length, 1));
  return text;
}

} // namespace

CropSection::CropSection(QWidget* parent)
    : FoldingSection(tr("Crop"), parent), m_toVisible(new QPushButton(tr("Crop to what is seen"))),
      m_turn(new QPushButton(tr("Turn to this view"))), m_reset(new QPushButton(tr("Reset crop"))) {
  const std::array<AxisName, 3> names = axisNames({}, false);
  for (int axis = 0; axis < 3; ++axis) {
    Row& row = m_rows[static_cast<std::size_t>(axis)];
    row.range = new RangeSlider(percentSpec(names[static_cast<std::size_t>(axis)], {}));
    row.extent = new QLabel;
    row.extent->setForegroundRole(QPalette::PlaceholderText);
    auto* both = new QVBoxLayout;
    both->setSpacing(0);
    both->addWidget(row.range);
    both->addWidget(row.extent);
    contents()->addLayout(both);
    connect(row.range, &RangeSlider::rangeEdited, this,
            [this, axis](double lower, double upper, const Gesture& gesture) {
              edit(axis, lower, upper, gesture);
            });
  }
  m_reset->setAccessibleName(m_reset->text());
  m_reset->setToolTip(tr("Shows the whole volume again."));
  m_toVisible->setAccessibleName(m_toVisible->text());
  m_toVisible->setToolTip(tr("<p>Draws the box close around what the curve, Body only and labels leave to be "
                             "seen, so that its handles lie there and not around air and table.</p>"));
  // Below each other: beside each other long words would make the panel wider.
  m_turn->setAccessibleName(m_turn->text());
  m_turn->setToolTip(tr("Puts a box over the picture that lies as the picture is seen now."));
  for (QPushButton* button : {m_toVisible, m_turn, m_reset})
    contents()->addWidget(button, 0, Qt::AlignLeft);
  connect(m_toVisible, &QAbstractButton::clicked, this, &CropSection::cropToVisible);
  connect(m_turn, &QAbstractButton::clicked, this, &CropSection::turnRequested);
  connect(m_reset, &QAbstractButton::clicked, this, [this] {
    m_crop = {};
    showCrop();
    emit cropEdited(m_crop, {nextGestureId(), tr("reset crop")});
  });
  showCrop();
}

void CropSection::setScene(const Scene& scene) {
  m_scene = scene;
  if (scene.volume != m_volume) {
    m_volume = scene.volume;
    for (int axis = 0; axis < 3; ++axis) {
      RangeSlider& range = *m_rows[static_cast<std::size_t>(axis)].range;
      range.setSpec(percentSpec(axisName(axis), axisLengthMm(m_volume.get(), axis)));
      range.setLeastApart(m_volume ? 100.0 / m_volume->grid().dims[axis] : 0.0); // one voxel
    }
  } else if (scene.crop == m_crop) {
    return;
  }
  m_crop = scene.crop;
  showCrop();
}

void CropSection::cropToVisible() {
  const IndexBox box = visibleBox(m_scene);
  const glm::dvec3 dims(m_volume->grid().dims);
  m_crop = {glm::max(box.lower / dims + 0.5, 0.0), glm::min(box.upper / dims + 0.5, 1.0)};
  showCrop();
  emit cropEdited(m_crop, {nextGestureId(), tr("crop to what is seen")});
}

AxisName CropSection::axisName(int axis) const {
  const auto names =
      m_volume ? axisNames(m_volume->grid(), m_volume->info().orientationKnown) : axisNames({}, false);
  return names[static_cast<std::size_t>(axis)];
}

void CropSection::edit(int axis, double lowerPercent, double upperPercent, const Gesture& gesture) {
  if (!m_volume)
    return showCrop();
  const Grid& grid = m_volume->grid();
  // Only the number that the user changed moves; the other keeps its digits beyond those shown.
  const CropFace lower{axis, false};
  const CropFace upper{axis, true};
  CropBox edited = m_crop;
  if (lowerPercent != 100.0 * placeOf(m_crop, lower))
    edited = withFaceAt(edited, grid, lower, lowerPercent / 100.0);
  if (upperPercent != 100.0 * placeOf(m_crop, upper))
    edited = withFaceAt(edited, grid, upper, upperPercent / 100.0);
  m_crop = edited;
  showCrop();
  const QString name = axisName(axis).axis;
  emit cropEdited(edited, {gesture.id, tr("crop %1").arg(inSentence(name))});
}

void CropSection::showCrop() {
  for (int axis = 0; axis < 3; ++axis) {
    const Row& row = m_rows[static_cast<std::size_t>(axis)];
    row.range->setRange(100.0 * m_crop.lower[axis], 100.0 * m_crop.upper[axis]);
    row.extent->setText(m_volume ? extentText(m_crop, *m_volume, axis) : QString());
  }
  const bool cuts = m_crop != CropBox{};
  m_reset->setEnabled(cuts);
  m_toVisible->setEnabled(m_volume != nullptr);
  m_turn->setEnabled(m_volume != nullptr);
  setSummary(cuts ? tr("%1 % kept").arg(plainNumber(100.0 * shareLeft(m_crop), 1)) : tr("off"));
}

} // namespace limn
