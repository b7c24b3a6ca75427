// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/surface/SurfaceDialog.h"

#include "widgets/controls/NumberField.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {
namespace {

QHBoxLayout* withUnit(QWidget* field, QLabel* unit) {
  auto* row = new QHBoxLayout;
  unit->setMinimumWidth(unit->fontMetrics().horizontalAdvance(QStringLiteral("mm³ "))); // fields end alike
  row->addWidget(field, 1);
  row->addWidget(unit);
  return row;
}

} // namespace

SurfaceDialog::SurfaceDialog(QWidget* parent)
    : WorkDialog(QStringLiteral("surface"), tr("Making the surface"), parent),
      m_value(new NumberField(-1e9, 1e9, 4, this)), m_unit(new QLabel(this)), m_origin(new QLabel(this)),
      m_isClosed(new QCheckBox(tr("&Close holes where crop or volume end (printing needs it)"), this)),
      m_smallest(new NumberField(0.0, 1e9, 1, this)), m_tolerance(new NumberField(0.0, 100.0, 3, this)),
      m_cells(new QComboBox(this)) {
  setWindowTitle(tr("Export a surface"));
  name();
  m_isClosed->setChecked(true);
  m_isClosed->setToolTip(
      tr("Flat faces close the surface where the crop, the volume or what is kept of it ends."));
  m_smallest->setNumber(10.0);
  m_smallest->setToolTip(
      tr("Specks that enclose less are left out, and smaller hollows filled; 0 keeps all."));
  m_tolerance->setToolTip(
      tr("Triangles are taken away as far as this distance from the isosurface allows; 0 keeps "
         "all."));
  m_cells->addItem(tr("As fine as the voxels"), 1);
  m_cells->addItem(tr("Twice as fine (4 times the triangles)"), 2);
  m_cells->addItem(tr("3 times as fine (9 times the triangles)"), 3);
  layOut();
  connect(m_value, &NumberField::numberEdited, this, [this] {
    m_origin->clear();
    emit orderEdited();
  });
  connect(m_tolerance, &NumberField::numberEdited, this, &SurfaceDialog::orderEdited);
  connect(m_cells, &QComboBox::activated, this, &SurfaceDialog::orderEdited);
}

void SurfaceDialog::name() {
  m_value->setObjectName(QStringLiteral("surfaceValue"));
  m_isClosed->setObjectName(QStringLiteral("surfaceClosed"));
  m_smallest->setObjectName(QStringLiteral("surfaceSmallest"));
  m_tolerance->setObjectName(QStringLiteral("surfaceTolerance"));
  m_cells->setObjectName(QStringLiteral("surfaceCells"));
  m_value->setAccessibleName(tr("Value of the surface"));
  m_smallest->setAccessibleName(tr("Smallest part in cubic millimetres"));
  m_tolerance->setAccessibleName(tr("Distance from the isosurface in millimetres"));
}

void SurfaceDialog::layOut() {
  auto* form = new QFormLayout;
  const auto add = [&](const QString& label, QWidget* field, QLabel* unit) {
    auto* text = new QLabel(label, this);
    text->setBuddy(field);
    form->addRow(text, withUnit(field, unit));
  };
  add(tr("&Value"), m_value, m_unit);
  m_origin->setWordWrap(true);
  form->addRow(QString(), m_origin);
  form->addRow(QString(), m_isClosed);
  add(tr("Leave out &parts below"), m_smallest, new QLabel(tr("mm³"), this));
  add(tr("&Simplify within"), m_tolerance, new QLabel(tr("mm"), this));
  form->addRow(tr("&Detail"), m_cells);
  text()->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text()->setMinimumHeight(4 * fontMetrics().lineSpacing());
  text()->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* start = new QPushButton(tr("&Export…"), this);
  start->setObjectName(QStringLiteral("surfaceExport"));
  connect(start, &QPushButton::clicked, this, &SurfaceDialog::exportRequested);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  addFoot(column, start);
  column->setStretchFactor(text(), 1);
  setMinimumWidth(480);
}

void SurfaceDialog::setValue(double value, const QString& unit, const QString& origin) {
  m_value->setNumber(value);
  m_unit->setText(unit);
  m_origin->setText(origin);
}

void SurfaceDialog::setTolerance(double mm) {
  m_tolerance->setNumber(mm);
}

double SurfaceDialog::value() const {
  return m_value->number();
}

bool SurfaceDialog::isClosed() const {
  return m_isClosed->isChecked();
}

double SurfaceDialog::smallestPartMm3() const {
  return m_smallest->number();
}

double SurfaceDialog::toleranceMm() const {
  return m_tolerance->number();
}

int SurfaceDialog::cells() const {
  return m_cells->currentData().toInt();
}

void SurfaceDialog::showEstimate(const QString& sentence) {
  setStartable(true);
  say(sentence);
}

void SurfaceDialog::showRefusal(const QString& sentence) {
  setStartable(false);
  say(sentence);
}

QString SurfaceDialog::doing(double) const {
  return tr("Making the surface and measuring it…");
}

} // namespace limn
