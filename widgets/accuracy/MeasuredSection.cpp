// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/MeasuredSection.h"

#include "accuracy/sweep/FigureText.h"
#include "widgets/Translated.h"
#include "widgets/accuracy/AccuracyChart.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/WorkRow.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {

MeasuredSection::MeasuredSection(QWidget* parent)
    : FoldingSection(tr("Measured on this computer"), parent), m_measure(new QPushButton(tr("Measure"))),
      m_save(new QPushButton(tr("Save…"))), m_apart(new QPushButton(tr("Enlarge"))),
      m_work(new WorkRow(tr("Measuring"))), m_summary(new QLabel), m_chart(new AccuracyChart),
      m_window(new ChartWindow(this)) {
  addButtons();
  contents()->addWidget(m_work);
  m_summary->setObjectName(QStringLiteral("summary"));
  m_summary->setWordWrap(true);
  m_summary->setForegroundRole(QPalette::PlaceholderText);
  contents()->addWidget(m_summary);
  contents()->addWidget(m_chart);
  addMeasureChoice();
  connect(m_measure, &QPushButton::clicked, this, &MeasuredSection::measureRequested);
  connect(m_save, &QPushButton::clicked, this, &MeasuredSection::saveRequested);
  connect(m_chart, &AccuracyChart::pointPicked, this, &MeasuredSection::pointPicked);
  connectApart();
  setMeasured(nullptr);
}

void MeasuredSection::addButtons() {
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  m_measure->setAccessibleName(tr("Measure error and time"));
  m_measure->setToolTip(
      tr("<p>Draws this picture from fast to nearly exact and times each, in at most 224 pixels each way: "
         "from seconds to some minutes. You can go on working; work beside it makes its times longer.</p>"));
  m_save->setAccessibleName(tr("Save what was measured"));
  m_save->setToolTip(
      tr("Writes the chart as a picture (PNG), the numbers as a table (CSV), or both as a page (HTML)."));
  buttons->addWidget(m_measure);
  buttons->addStretch(1);
  m_apart->setCheckable(true);
  m_apart->setAccessibleName(tr("Chart in a window of its own"));
  m_apart->setToolTip(tr("Shows the chart in a window of its own, where it is larger."));
  buttons->addWidget(m_apart);
  buttons->addWidget(m_save);
  contents()->addLayout(buttons);
}

void MeasuredSection::addMeasureChoice() {
  m_choice = new ChoiceRow(tr("Error shown"),
                           tr("The 99.9th percentile is the error that 999 of 1000 colour values stay "
                              "within; the mean is taken over all of them."),
                           {tr("99.9th percentile"), tr("Mean")}, 0);
  contents()->addWidget(m_choice);
  connect(m_choice, &ChoiceRow::indexEdited, this,
          [this](int index) { m_chart->setMeasure(index == 0 ? ErrorMeasure::p99_9 : ErrorMeasure::mean); });
}

void MeasuredSection::connectApart() {
  connect(m_apart, &QPushButton::clicked, this, &MeasuredSection::setApart);
  connect(m_window, &QDialog::finished, this, [this] { setApart(false); });
}

void MeasuredSection::setApart(bool isApart) {
  m_apart->setChecked(isApart);
  if (isApart)
    return m_window->openBeside(*m_chart, *this);
  contents()->insertWidget(contents()->indexOf(m_choice), m_chart);
  m_chart->show();
  m_window->hide();
}

QWidget* MeasuredSection::chart() const {
  return m_chart;
}

void MeasuredSection::fitInto(int height) {
  if (m_apart->isChecked())
    return;
  const int whole = hasHeightForWidth() ? heightForWidth(width()) : sizeHint().height();
  m_chart->setPreferredHeight(height - (whole - m_chart->sizeHint().height()));
}

void MeasuredSection::setMeasured(const MeasuredAccuracy* measured) {
  m_report = measured ? measured->report : AccuracyReport{};
  m_timedSize = measured ? measured->timedSize : glm::ivec2(0);
  m_chart->setReport(m_report);
  const bool isShown = !m_report.points.empty();
  m_chart->setVisible(isShown);
  m_choice->setVisible(isShown);
  m_save->setVisible(isShown);
  m_apart->setVisible(isShown);
  showSummary();
}

void MeasuredSection::setRelation(MeasuredFor relation) {
  m_relation = relation;
  m_chart->setStale(relation == MeasuredFor::earlierPicture);
  showSummary();
}

void MeasuredSection::setCurrent(std::optional<std::size_t> point) {
  m_chart->setCurrent(point);
}

void MeasuredSection::setCanMeasure(bool can) {
  m_measure->setEnabled(can);
  m_summary->setVisible(can || !m_report.points.empty()); // while it measures, that is said
}

void MeasuredSection::showSummary() {
  if (m_report.points.empty()) {
    m_summary->setText(tr("Nothing is measured yet. Measure tells the error and the time of this picture, "
                          "from fast to exact."));
    return;
  }
  m_summary->setToolTip(tr("Drawn by %1").arg(QString::fromStdString(m_report.renderer)));
  QString how = tr("At %1 × %2 pixels.").arg(m_report.size.x).arg(m_report.size.y);
  if (m_timedSize != glm::ivec2(0) && m_timedSize != m_report.size)
    how += QLatin1Char(' ') + tr("Times are scaled from there to the %1 × %2 pixels on screen.")
                                  .arg(m_timedSize.x)
                                  .arg(m_timedSize.y);
  if (const Message law = lawOfPaths(m_report.points); !law.empty())
    how += QLatin1Char(' ') + translated(law);
  switch (m_relation) {
  case MeasuredFor::thisPicture:
    m_summary->setText(how);
    break;
  case MeasuredFor::otherCamera:
    m_summary->setText(tr("Measured in another view. %1").arg(how));
    break;
  case MeasuredFor::earlierPicture:
    m_summary->setText(tr("Measured for an earlier picture; measure again to judge this one."));
    break;
  }
}

} // namespace limn
