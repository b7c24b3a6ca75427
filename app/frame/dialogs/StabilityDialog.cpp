// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/dialogs/StabilityDialog.h"

#include <QDesktopServices>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

namespace limn {
namespace {

QString lastLine(const QByteArray& text) {
  return QString::fromUtf8(text).trimmed().section(QLatin1Char('\n'), -1);
}

} // namespace

StabilityDialog::StabilityDialog(const QString& program, const QString& folder, QWidget* parent)
    : QDialog(parent), m_program(program), m_folder(folder), m_text(new QLabel(this)),
      m_bar(new QProgressBar(this)), m_start(new QPushButton(tr("Check"), this)),
      m_stop(new QPushButton(tr("Stop"), this)), m_open(new QPushButton(tr("Open the report"), this)) {
  setWindowTitle(tr("Stability checks"));
  m_text->setWordWrap(true);
  m_text->setMinimumWidth(420);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_text->setText(
      tr("Checks the graphics driver of this computer with pictures whose right result is known. Takes some "
         "minutes; you can go on working."));
  m_bar->setRange(0, 0);
  m_bar->setTextVisible(false);
  m_bar->setAccessibleName(tr("Checking"));
  auto* row = new QHBoxLayout;
  row->addStretch();
  for (QPushButton* button : {m_open, m_stop, m_start})
    row->addWidget(button);
  auto* close = new QPushButton(tr("Close"), this);
  close->setToolTip(tr("Running checks go on."));
  row->addWidget(close);
  m_start->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(m_text);
  column->addWidget(m_bar);
  column->addLayout(row);
  showRunning(false);
  m_open->hide();
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_start, &QPushButton::clicked, this, &StabilityDialog::start);
  connect(m_stop, &QPushButton::clicked, &m_process, &QProcess::kill);
  connect(m_open, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QDir(m_folder).filePath(QStringLiteral("stability.html"))));
  });
  connect(&m_process, &QProcess::finished, this, &StabilityDialog::showEnd);
  connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart)
      return; // finished tells
    showRunning(false);
    m_text->setText(tr("The checks could not be started: %1.").arg(m_process.errorString()));
  });
}

// Nobody is told of its end any more.
StabilityDialog::~StabilityDialog() {
  m_process.disconnect(this);
  m_process.kill();
  m_process.waitForFinished();
}

void StabilityDialog::start() {
  m_open->hide();
  m_text->setText(tr("Checking…"));
  showRunning(true);
  m_process.start(m_program, {QStringLiteral("stability"), QStringLiteral("-o"), m_folder});
}

void StabilityDialog::showEnd(int exitCode, QProcess::ExitStatus status) {
  showRunning(false);
  const QString summary = lastLine(m_process.readAllStandardOutput());
  const QString error = lastLine(m_process.readAllStandardError());
  if (status == QProcess::CrashExit)
    m_text->setText(tr("The checks ended before they were complete, by you or by the driver."));
  else
    m_text->setText(exitCode == 0 || error.isEmpty() ? summary : summary + QLatin1Char('\n') + error);
  m_open->setVisible(status == QProcess::NormalExit &&
                     QDir(m_folder).exists(QStringLiteral("stability.html")));
}

void StabilityDialog::showRunning(bool runs) {
  m_bar->setVisible(runs);
  m_stop->setVisible(runs);
  m_start->setVisible(!runs);
}

} // namespace limn
