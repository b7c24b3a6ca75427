// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom/DicomDialog.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {
namespace {

QLabel* wrapped(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  return label;
}

} // namespace

DicomDialog::DicomDialog(QWidget* parent)
    : QDialog(parent), m_picture(wrapped({}, this)), m_carries(wrapped({}, this)),
      m_anonymous(new QCheckBox(tr("&Leave out what the series says of its patient and study"), this)),
      m_losses(new QListWidget(this)), m_text(wrapped({}, this)), m_bar(new QProgressBar(this)),
      m_save(new QPushButton(tr("&Save…"), this)), m_close(new QPushButton(tr("Close"), this)) {
  setWindowTitle(tr("Save to DICOM"));
  m_anonymous->setObjectName(QStringLiteral("dicomAnonymous"));
  m_anonymous->setToolTip(tr("The UIDs of study and images stay: by them the look finds its images."));
  m_losses->setObjectName(QStringLiteral("dicomLosses"));
  m_losses->setWordWrap(true);
  m_losses->setSpacing(2);
  m_losses->setSelectionMode(QAbstractItemView::NoSelection);
  m_losses->setAccessibleName(tr("What other programs see differently"));
  m_text->setObjectName(QStringLiteral("dicomSays"));
  m_text->hide();
  m_bar->setRange(0, 1000);
  m_bar->setTextVisible(false);
  m_bar->setAccessibleName(tr("Drawing the picture"));
  m_bar->hide();
  m_save->setObjectName(QStringLiteral("dicomSave"));
  m_close->setObjectName(QStringLiteral("dicomClose"));
  auto* lossTitle =
      wrapped(tr("What &others see differently (Limn reads all of it back, but for kept labels):"), this);
  lossTitle->setBuddy(m_losses);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(m_close);
  buttons->addWidget(m_save);
  m_close->setAutoDefault(false);
  m_save->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(
      wrapped(tr("Saves two files for an archive: the picture (picture.dcm) and the look that it "
                 "was made with (look.dcm), which other programs and Limn can open."),
              this));
  column->addWidget(m_picture);
  column->addWidget(m_carries);
  column->addWidget(m_anonymous);
  column->addWidget(lossTitle);
  column->addWidget(m_losses, 1);
  column->addWidget(m_text);
  column->addWidget(m_bar);
  column->addLayout(buttons);
  setMinimumWidth(520);
  connect(m_anonymous, &QCheckBox::toggled, this, &DicomDialog::sayWhatTheyCarry);
  sayWhatTheyCarry();
  connect(m_save, &QPushButton::clicked, this, &DicomDialog::saveRequested);
  connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
}

bool DicomDialog::isAnonymous() const {
  return m_anonymous->isChecked();
}

void DicomDialog::sayWhatTheyCarry() {
  m_carries->setText(isAnonymous()
                         ? tr("The two files name nobody. They keep the UIDs of the study and of its images, "
                              "by which the look finds them.")
                         : tr("The two files carry what the series says of its patient, because an archive "
                              "files them by it. Nothing else that Limn writes does."));
}

void DicomDialog::setPicture(const QString& sentence) {
  m_picture->setText(sentence);
}

void DicomDialog::setLosses(const QStringList& sentences) {
  if (sentences == m_shown)
    return; // or a screen reader would lose its place whenever the camera moves
  m_shown = sentences;
  m_losses->clear();
  m_losses->addItems(sentences);
}

void DicomDialog::showProgress(double fraction) {
  m_bar->setValue(static_cast<int>(1000.0 * fraction));
  m_bar->show();
  m_save->setEnabled(false);
  m_close->setText(tr("Cancel"));
  m_text->setText(tr("Drawing the picture…"));
  m_text->show();
}

void DicomDialog::endProgress(const QString& text) {
  m_bar->hide();
  m_save->setEnabled(true);
  m_close->setText(tr("Close"));
  m_text->setText(text);
  m_text->show();
}

bool DicomDialog::isWorking() const {
  return !m_bar->isHidden();
}

void DicomDialog::done(int result) {
  if (isWorking())
    emit cancelled();
  else
    QDialog::done(result);
}

} // namespace limn
