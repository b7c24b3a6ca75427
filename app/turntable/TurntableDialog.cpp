// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/turntable/TurntableDialog.h"

#include "app/turntable/Turntable.h"
#include "widgets/controls/NumberField.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

// A driver's and a video's frames are no larger.
constexpr double mostSide = 8192.0;

} // namespace

TurntableDialog::TurntableDialog(bool hasVideo, QWidget* parent)
    : WorkDialog(QStringLiteral("turntable"), tr("Drawing the turntable"), parent),
      m_width(new NumberField(16.0, mostSide, 0, this)), m_height(new NumberField(16.0, mostSide, 0, this)),
      m_frames(new NumberField(2.0, mostFrames, 0, this)), m_perSecond(new NumberField(1.0, 240.0, 0, this)),
      m_kind(new QComboBox(this)), m_picture(new QComboBox(this)), m_form(new QFormLayout) {
  setWindowTitle(tr("Save a turntable"));
  m_kind->setObjectName(QStringLiteral("turntableKind"));
  m_kind->addItem(tr("Frames in a folder (PNG)"));
  if (hasVideo)
    m_kind->addItem(tr("Video (MP4)"));
  m_picture->setObjectName(QStringLiteral("turntablePicture"));
  m_frames->setObjectName(QStringLiteral("turntableFrames"));
  m_width->setObjectName(QStringLiteral("turntableWidth"));
  m_height->setObjectName(QStringLiteral("turntableHeight"));
  m_width->setAccessibleName(tr("Width in pixels"));
  m_height->setAccessibleName(tr("Height in pixels"));
  m_frames->setNumber(90.0);
  m_perSecond->setNumber(25.0);
  auto* size = new QHBoxLayout;
  size->addWidget(m_width, 1);
  size->addWidget(new QLabel(QStringLiteral("×"), this));
  size->addWidget(m_height, 1);
  size->addWidget(new QLabel(tr("pixels"), this));
  m_form->addRow(tr("Save &as"), m_kind);
  m_form->addRow(tr("&Picture"), m_picture);
  m_form->addRow(tr("Size"), size);
  m_form->addRow(tr("&Frames for one turn"), m_frames);
  m_form->addRow(tr("Frames per s&econd"), m_perSecond);
  if (!hasVideo) {
    auto* missing = new QLabel(tr("A video can be made once the program ffmpeg is installed."), this);
    missing->setWordWrap(true);
    m_form->addRow(missing);
  }
  auto* save = new QPushButton(tr("&Save…"), this);
  save->setObjectName(QStringLiteral("turntableSave"));
  auto* column = new QVBoxLayout(this);
  column->addLayout(m_form);
  addFoot(column, save);
  setMinimumWidth(440);
  connect(save, &QPushButton::clicked, this, &TurntableDialog::saveRequested);
  for (NumberField* field : {m_frames, m_perSecond})
    connect(field, &NumberField::numberEdited, this, &TurntableDialog::showLength);
  showLength();
}

void TurntableDialog::showLength() {
  say(tr("One turn about the patient's upright axis: a frame each %1°, %2 s.")
          .arg(QLocale().toString(360.0 / frames(), 'f', 1),
               QLocale().toString(frames() / framesPerSecond(), 'f', 1)));
}

void TurntableDialog::setPictures(const QStringList& names, int usual) {
  QStringList before;
  for (int i = 0; i < m_picture->count(); ++i)
    before << m_picture->itemText(i);
  if (names == before)
    return;
  m_picture->clear();
  m_picture->addItems(names);
  m_picture->setCurrentIndex(usual);
  m_form->setRowVisible(m_picture, names.size() > 1);
}

int TurntableDialog::picture() const {
  return m_picture->currentIndex();
}

void TurntableDialog::setSize(const glm::ivec2& pixels) {
  m_width->setNumber(pixels.x);
  m_height->setNumber(pixels.y);
}

glm::ivec2 TurntableDialog::size() const {
  return {static_cast<int>(m_width->number()), static_cast<int>(m_height->number())};
}

int TurntableDialog::frames() const {
  return static_cast<int>(m_frames->number());
}

double TurntableDialog::framesPerSecond() const {
  return m_perSecond->number();
}

bool TurntableDialog::wantsVideo() const {
  return m_kind->currentIndex() == 1;
}

QString TurntableDialog::doing(double fraction) const {
  return tr("Drawing frame %1 of %2…")
      .arg(std::min(frames(), static_cast<int>(fraction * frames()) + 1))
      .arg(frames());
}

} // namespace limn
