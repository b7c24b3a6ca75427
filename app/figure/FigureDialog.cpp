// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figure/FigureDialog.h"

#include "app/figure/FigureOptions.h"
#include "app/figure/FigurePreview.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace limn {
namespace {

constexpr int sideWidth = 372;

} // namespace

FigureDialog::FigureDialog(QWidget* parent)
    : WorkDialog(QStringLiteral("figure"), tr("Making the figure"), parent),
      m_preview(new FigurePreview(this)), m_panels(new PanelList(this)), m_options(new FigureOptions(this)),
      m_exact(new QCheckBox(tr("As exact as a screen shows"), this)) {
  setWindowTitle(tr("Save a figure"));
  m_exact->setObjectName(QStringLiteral("figureExact"));
  m_exact->setToolTip(tr("Draws within half a level of 255 of the exact picture, which takes longer than the "
                         "window's own steps."));
  m_exact->setChecked(true);
  QWidget* side = makeSide();
  connect(this, &WorkDialog::workingChanged, side, &QWidget::setDisabled);
  auto* row = new QHBoxLayout;
  row->addWidget(m_preview, 1);
  row->addWidget(side);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  addButtons(column);
  connect(m_panels, &PanelList::edited, this, &FigureDialog::edited);
  connect(m_options, &FigureOptions::edited, this, &FigureDialog::edited);
  connect(m_exact, &QCheckBox::clicked, this, &FigureDialog::edited);
  connect(m_preview, &FigurePreview::resized, this, &FigureDialog::previewResized);
  resize(1100, 660);
}

QWidget* FigureDialog::makeSide() {
  auto* side = new QWidget;
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(8, 12, 8, 4);
  column->setSpacing(12);
  column->addWidget(m_panels);
  column->addWidget(m_options);
  column->addWidget(m_exact);
  column->addStretch();
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus); // its fields have it
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(side);
  scroll->setFixedWidth(sideWidth);
  return scroll;
}

void FigureDialog::addButtons(QVBoxLayout* column) {
  auto* save = new QPushButton(tr("&Save…"), this);
  auto* copy = new QPushButton(tr("&Copy"), this);
  save->setObjectName(QStringLiteral("figureSave"));
  copy->setObjectName(QStringLiteral("figureCopy"));
  copy->setToolTip(tr("Copies the figure to the clipboard, in full size."));
  connect(save, &QPushButton::clicked, this, &FigureDialog::saveRequested);
  connect(copy, &QPushButton::clicked, this, &FigureDialog::copyRequested);
  addFoot(column, save, copy);
}

Figure FigureDialog::figure() const {
  return {m_options->settings(), m_panels->panels()};
}

bool FigureDialog::isExact() const {
  return m_exact->isChecked();
}

void FigureDialog::setExact(bool isExact) {
  m_exact->setChecked(isExact);
}

void FigureDialog::describe(const QString& text, bool canBeMade) {
  say(text);
  setStartable(canBeMade && !isWorking());
}

QString FigureDialog::doing(double) const {
  return tr("Drawing the figure…");
}

} // namespace limn
