// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/LookReport.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTextEdit>
#include <QVBoxLayout>

namespace limn {
namespace {

QString htmlOf(const LookReportEntry& entry) {
  QString html =
      QStringLiteral("<p><b>%1</b> – %2</p>").arg(entry.file.toHtmlEscaped(), entry.outcome.toHtmlEscaped());
  if (entry.sentences.isEmpty())
    return html;
  html += QStringLiteral("<ul>");
  for (const QString& sentence : entry.sentences)
    html += QStringLiteral("<li>%1</li>").arg(sentence.toHtmlEscaped());
  return html + QStringLiteral("</ul>");
}

QString textOf(const LookReportEntry& entry) {
  QString text = QStringLiteral("%1 – %2\n").arg(entry.file, entry.outcome);
  for (const QString& sentence : entry.sentences)
    text += QStringLiteral("  • %1\n").arg(sentence);
  return text;
}

} // namespace

LookReport::LookReport(const QString& title, const QString& summary,
                       const std::vector<LookReportEntry>& entries, QWidget* parent)
    : QDialog(parent), m_plainText(summary + QLatin1Char('\n')) {
  setObjectName(QStringLiteral("lookReport"));
  setWindowTitle(title);
  auto* heading = new QLabel(summary, this);
  heading->setWordWrap(true);
  QString html;
  for (const LookReportEntry& entry : entries) {
    html += htmlOf(entry);
    m_plainText += textOf(entry);
  }
  auto* text = new QTextEdit(this);
  text->document()->setDocumentMargin(8.0);
  text->document()->setIndentWidth(16.0);
  text->setHtml(html);
  text->setReadOnly(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text->setTabChangesFocus(true);
  text->setAccessibleName(tr("What changed"));
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
  QPushButton* close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
  copy->setAutoDefault(false);
  close->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(heading);
  column->addWidget(text, 1);
  column->addWidget(buttons);
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(m_plainText); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  close->setFocus();
  resize(560, 340);
}

} // namespace limn
