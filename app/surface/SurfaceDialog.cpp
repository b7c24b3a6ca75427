// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/surface/SurfaceDialog.h"

#include "widgets/controls/NumberField.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
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
    : QDialog(parent), m_value(new NumberField(-1e9, 1e9, 4, this)), m_unit(new QLabel(this)),
      m_origin(new QLabel(this)),
      m_isClosed(new QCheckBox(tr("&Close holes where crop or volume end (printing needs it)"), this)),
      m_smallest(new NumberField(0.0, 1e9, 1, this)), m_tolerance(new NumberField(0.0, 100.0, 3, this)),
      m_cells(new QComboBox(this)), m_text(new QLabel(this)), m_bar(new QProgressBar(this)),
      m_export(new QPushButton(tr("&Export…"), this)), m_close(new QPushButton(tr("Close"), this)) {
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
  connect(m_export, &QPushButton::clicked, this, &SurfaceDialog::exportRequested);
  connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
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
  m_text->setObjectName(QStringLiteral("surfaceSays"));
  m_export->setObjectName(QStringLiteral("surfaceExport"));
  m_close->setObjectName(QStringLiteral("surfaceClose"));
  m_value->setAccessibleName(tr("Value of the surface"));
  m_smallest->setAccessibleName(tr("Smallest part in cubic millimetres"));
  m_tolerance->setAccessibleName(tr("Distance from the isosurface in millimetres"));
  m_bar->setAccessibleName(tr("Making the surface"));
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
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_text->setMinimumHeight(4 * fontMetrics().lineSpacing());
  m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_bar->setRange(0, 1000);
  m_bar->setTextVisible(false);
  m_bar->hide();
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(m_close);
  buttons->addWidget(m_export);
  m_close->setAutoDefault(false);
  m_export->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(m_text, 1);
  column->addWidget(m_bar);
  column->addLayout(buttons);
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

void SurfaceDialog::showEstimate(const QString& text) {
  m_export->setEnabled(true);
  m_text->setText(text);
}

void SurfaceDialog::showRefusal(const QString& sentence) {
  m_export->setEnabled(false);
  m_text->setText(sentence);
}

void SurfaceDialog::showProgress(double fraction) {
  m_bar->setValue(static_cast<int>(1000.0 * fraction));
  m_bar->show();
  m_export->setEnabled(false);
  m_close->setText(tr("Cancel"));
  m_text->setText(tr("Making the surface and measuring it…"));
}

void SurfaceDialog::endProgress(const QString& text) {
  m_bar->hide();
  m_close->setText(tr("Close"));
  showEstimate(text);
}

bool SurfaceDialog::isWorking() const {
  return !m_bar->isHidden();
}

void SurfaceDialog::done(int result) {
  if (isWorking())
    emit cancelled();
  else
    QDialog::done(result);
}

} // namespace limn
