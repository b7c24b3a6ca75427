// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/exports/ExportDialog.h"

#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

// As wide as the widest of its words, so that what stands beside it stays there.
void fitToWords(QPushButton& button, const QStringList& words) {
  int widest = 0;
  for (const QString& each : words) {
    button.setText(each);
    widest = std::max(widest, button.sizeHint().width());
  }
  button.setMinimumWidth(widest);
}

} // namespace

ExportDialog::ExportDialog(WindowContext& context, const Words& words)
    : QDialog(&context.window), m_context(context), m_cancelled(words.cancelled), m_text(new QLabel(this)),
      m_bar(new QProgressBar(this)), m_close(new QPushButton(tr("Close"), this)) {
  m_text->setObjectName(words.name + QStringLiteral("Says"));
  m_text->setWordWrap(true);
  m_text->hide();
  m_bar->setRange(0, 1000);
  m_bar->setTextVisible(false);
  m_bar->setAccessibleName(words.work);
  QSizePolicy policy = m_bar->sizePolicy();
  policy.setRetainSizeWhenHidden(true); // nothing moves as work begins
  m_bar->setSizePolicy(policy);
  m_bar->hide();
  fitToWords(*m_close, {tr("Cancel"), tr("Close")});
  m_close->setObjectName(words.name + QStringLiteral("Close"));
  m_close->setAutoDefault(false);
  connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
  connect(&m_work, &BackgroundWork::progressed, this, [this](double fraction) {
    if (isWorking())
      showProgress(fraction);
  });
  connect(&m_work, &BackgroundWork::failed, this, &ExportDialog::end);
  connect(this, &ExportDialog::workingChanged, &context.view, &CompareView::pauseRefinement);
}

void ExportDialog::present() {
  m_context.planes.endLooseDrag(); // what lacks places is no measurement of what is open
  begin(!isVisible());
  show();
  raise();
  activateWindow();
}

// What is under way when the volume goes ends by itself; nothing more can be begun until there is another.
void ExportDialog::follow(const Scene& scene, bool isSuited) {
  const bool isSuitedAgain = isSuited && !m_isSuited;
  m_isSuited = isSuited;
  if (isSuitedAgain && !isWorking())
    setStartable(true);
  if (isSuited)
    showScene(scene);
  else if (!isWorking())
    close();
}

void ExportDialog::run(const Work& work) {
  showProgress(0.0);
  m_work.start([this, work](const Effort& effort) -> BackgroundWork::Deliver {
    return [this, outcome = work(effort)] {
      end(outcome.sentence);
      if (outcome.deliver)
        outcome.deliver();
    };
  });
}

void ExportDialog::exportTo(const SaveQuestion& question, const Writing& write) {
  const QString path = askWhereToSave(this, question, m_context.settings);
  if (path.isEmpty())
    return;
  run([this, path, write](const Effort& effort) {
    Outcome outcome = write(path.toStdString(), effort);
    outcome.deliver = [this, path] { m_context.notes.attempt([] {}, path); };
    return outcome;
  });
}

void ExportDialog::addFoot(QVBoxLayout* column, QPushButton* start, QPushButton* other) {
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  if (other) {
    other->setAutoDefault(false);
    buttons->addWidget(other);
    m_starts.push_back(other);
  }
  buttons->addWidget(m_close);
  buttons->addWidget(start);
  start->setDefault(true);
  m_starts.push_back(start);
  m_text->setMinimumHeight(2 * fontMetrics().lineSpacing());
  m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  column->addWidget(m_text);
  column->addWidget(m_bar);
  column->addLayout(buttons);
}

void ExportDialog::showProgress(double fraction) {
  const bool wasWorking = isWorking();
  m_bar->setValue(static_cast<int>(1000.0 * fraction));
  m_bar->show();
  if (!wasWorking) {
    m_before = focusWidget();
    m_left.begin(m_pictures, m_telling);
  }
  setStartable(false);
  m_close->setText(tr("Cancel"));
  say(doing(fraction) + m_left.text(atOnePace(fraction)));
  if (!wasWorking)
    emit workingChanged(true);
}

void ExportDialog::end(const QString& sentence) {
  const bool wasWorking = isWorking();
  m_bar->hide();
  setStartable(true);
  m_close->setText(tr("Close"));
  sayOutcome(sentence);
  if (!wasWorking)
    return;
  emit workingChanged(false);
  if (m_before && focusWidget() == m_close) // where the keyboard went as what had it could not be used
    m_before->setFocus(Qt::OtherFocusReason);
}

QWidget* ExportDialog::outOfUseWhileWorking(QLayout* fields) {
  auto* place = new QWidget(this);
  fields->setContentsMargins(0, 0, 0, 0);
  place->setLayout(fields);
  connect(this, &ExportDialog::workingChanged, place, &QWidget::setDisabled);
  return place;
}

bool ExportDialog::isWorking() const {
  return !m_bar->isHidden();
}

QString ExportDialog::said() const {
  return m_text->text();
}

void ExportDialog::say(const QString& text) {
  m_text->setText(text);
  m_text->setVisible(!text.isEmpty());
}

void ExportDialog::setStartable(bool isStartable) {
  for (QPushButton* start : m_starts)
    start->setEnabled(isStartable && m_isSuited);
}

// What runs ends first; closing takes a second step.
void ExportDialog::done(int result) {
  if (!isWorking())
    return QDialog::done(result);
  m_work.cancel();
  end(m_cancelled);
}

} // namespace limn
