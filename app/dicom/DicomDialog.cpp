// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dicom/DicomDialog.h"

#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
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
    : WorkDialog(QStringLiteral("dicom"), tr("Drawing the picture"), parent), m_picture(wrapped({}, this)),
      m_carries(wrapped({}, this)),
      m_anonymous(new QCheckBox(tr("&Leave out what the series says of its patient and study"), this)),
      m_losses(new QListWidget(this)) {
  setWindowTitle(tr("Save to DICOM"));
  m_anonymous->setObjectName(QStringLiteral("dicomAnonymous"));
  m_anonymous->setToolTip(tr("The UIDs of study and images stay: by them the look finds its images."));
  m_losses->setObjectName(QStringLiteral("dicomLosses"));
  m_losses->setWordWrap(true);
  m_losses->setSpacing(2);
  m_losses->setSelectionMode(QAbstractItemView::NoSelection);
  m_losses->setAccessibleName(tr("What other programs see differently"));
  auto* lossTitle =
      wrapped(tr("What &others see differently (Limn reads all of it back, but for kept labels):"), this);
  lossTitle->setBuddy(m_losses);
  auto* save = new QPushButton(tr("&Save…"), this);
  save->setObjectName(QStringLiteral("dicomSave"));
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
  addFoot(column, save);
  setMinimumWidth(520);
  connect(m_anonymous, &QCheckBox::toggled, this, &DicomDialog::sayWhatTheyCarry);
  sayWhatTheyCarry();
  connect(save, &QPushButton::clicked, this, &DicomDialog::saveRequested);
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

QString DicomDialog::doing(double) const {
  return tr("Drawing the picture…");
}

} // namespace limn
