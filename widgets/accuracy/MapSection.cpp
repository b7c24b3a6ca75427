// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/MapSection.h"

#include "widgets/ValueText.h"
#include "widgets/accuracy/PointUse.h"
#include "widgets/controls/WorkRow.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

QString sentenceOf(const ComparedPicture& compared) {
  if (!compared.reference.converged)
    return MapSection::tr("Not converged: the exact picture still changes with finer steps, so there is "
                          "nothing to compare with.");
  const QString name = pointText(compared.point);
  if (!compared.error)
    return MapSection::tr(
               "%1: the error is not known, because only what two paths or more differ by tells it.")
        .arg(name);
  const ImageError& error = *compared.error;
  if (compared.reference.isByChance)
    return MapSection::tr(
               "%1, at %2 × %3 pixels: the standard error of 999 of 1000 colour values is at most %4 "
               "levels of 255; that of %5 % of the pixels is more than one.")
        .arg(name)
        .arg(compared.map.size.x)
        .arg(compared.map.size.y)
        .arg(promisedLevels(error.p99_9),
             plainNumber(100.0 * error.shareOverOne, error.shareOverOne < 0.1 ? 2 : 0));
  return MapSection::tr("%1, compared at %2 × %3 pixels: 999 of 1000 colour values are within %4 levels of "
                        "255; %5 % of the pixels are off by more than one.")
      .arg(name.left(1).toUpper() + name.mid(1))
      .arg(compared.map.size.x)
      .arg(compared.map.size.y)
      .arg(promisedLevels(std::max(error.p99_9, leastP99_9(compared.reference))))
      .arg(plainNumber(100.0 * error.shareOverOne, error.shareOverOne < 0.1 ? 2 : 0));
}

} // namespace

MapSection::MapSection(QWidget* parent)
    : FoldingSection(tr("Where it differs"), parent),
      m_check(new QCheckBox(tr("Show where it is not exact"))),
      m_work(new WorkRow(tr("Comparing with the exact picture"))), m_sentence(new QLabel) {
  contents()->addWidget(m_check);
  contents()->addWidget(m_work);
  m_sentence->setObjectName(QStringLiteral("sentence"));
  m_sentence->setWordWrap(true);
  m_sentence->setForegroundRole(QPalette::PlaceholderText);
  contents()->addWidget(m_sentence);
  m_check->setAccessibleName(m_check->text());
  connect(m_check, &QCheckBox::clicked, this, &MapSection::mapRequested);
  setUnavailable({});
  setCompared(nullptr);
}

void MapSection::setUnavailable(const QString& reason) {
  m_check->setEnabled(reason.isEmpty());
  m_check->setToolTip(
      reason.isEmpty()
          ? tr("<p>Colours the picture by how far it lies from the exact one, in levels of 255. That one is "
               "drawn first, which takes from seconds to some minutes and says how long as it goes on. The "
               "next change of the picture takes the map away.</p>")
          : reason);
}

void MapSection::setComparing(bool isComparing) {
  m_check->setChecked(isComparing);
  if (isComparing)
    m_sentence->hide();
}

void MapSection::sayEnded(const QString& sentence) {
  m_sentence->setText(sentence);
  m_sentence->show();
}

void MapSection::setCompared(const ComparedPicture* compared) {
  m_check->setChecked(compared && compared->error);
  m_sentence->setText(compared ? sentenceOf(*compared) : QString());
  m_sentence->setVisible(compared);
}

} // namespace limn
