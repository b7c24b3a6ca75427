// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figure/FigureDialog.h"

#include "app/figure/FigureOptions.h"
#include "app/figure/FigurePreview.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace limn {
namespace {

constexpr int sideWidth = 372;

} // namespace

FigureDialog::FigureDialog(QWidget* parent)
    : QDialog(parent), m_preview(new FigurePreview(this)), m_panels(new PanelList(this)),
      m_options(new FigureOptions(this)), m_exact(new QCheckBox(tr("As exact as a screen shows"), this)),
      m_text(new QLabel(this)), m_bar(new QProgressBar(this)) {
  setWindowTitle(tr("Save a figure"));
  m_exact->setObjectName(QStringLiteral("figureExact"));
  m_exact->setToolTip(tr("Draws within half a level of 255 of the exact picture, which takes longer than the "
                         "window's own steps."));
  m_exact->setChecked(true);
  m_text->setWordWrap(true);
  m_text->setObjectName(QStringLiteral("figureSays"));
  m_bar->setTextVisible(false);
  m_bar->setRange(0, 1000);
  m_bar->setAccessibleName(tr("Making the figure"));
  m_bar->hide();
  auto* row = new QHBoxLayout;
  row->addWidget(m_preview, 1);
  row->addWidget(m_side = makeSide());
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(m_text);
  column->addWidget(m_bar);
  column->addWidget(makeButtons());
  connect(m_panels, &PanelList::edited, this, &FigureDialog::edited);
  connect(m_options, &FigureOptions::edited, this, &FigureDialog::edited);
  connect(m_exact, &QCheckBox::clicked, this, &FigureDialog::edited);
  connect(m_preview, &FigurePreview::resized, this, &FigureDialog::edited);
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

QWidget* FigureDialog::makeButtons() {
  auto* buttons = new QWidget(this);
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](QPushButton*& button, const QString& text, const char* name) {
    button = new QPushButton(text, buttons);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    row->addWidget(button);
  };
  row->addStretch();
  add(m_copy, tr("&Copy"), "figureCopy");
  add(m_close, tr("Close"), "figureClose");
  add(m_save, tr("&Save…"), "figureSave");
  m_copy->setToolTip(tr("Copies the figure to the clipboard, in full size."));
  m_save->setDefault(true);
  connect(m_save, &QPushButton::clicked, this, &FigureDialog::saveRequested);
  connect(m_copy, &QPushButton::clicked, this, &FigureDialog::copyRequested);
  connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
  return buttons;
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

void FigureDialog::say(const QString& text, bool canBeMade) {
  m_text->setText(text);
  m_save->setEnabled(canBeMade && !isWorking());
  m_copy->setEnabled(canBeMade && !isWorking());
}

void FigureDialog::showProgress(double fraction, const QString& doing) {
  m_bar->setValue(static_cast<int>(1000.0 * fraction));
  m_bar->show();
  m_text->setText(doing);
  m_side->setEnabled(false);
  m_save->setEnabled(false);
  m_copy->setEnabled(false);
  m_close->setText(tr("Cancel"));
}

void FigureDialog::endProgress() {
  m_bar->hide();
  m_side->setEnabled(true);
  m_close->setText(tr("Close"));
}

bool FigureDialog::isWorking() const {
  return !m_bar->isHidden();
}

// What runs ends first; closing takes a second step.
void FigureDialog::done(int result) {
  if (isWorking())
    emit cancelled();
  else
    QDialog::done(result);
}

} // namespace limn
