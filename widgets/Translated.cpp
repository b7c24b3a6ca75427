// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Translated.h"

#include <QCoreApplication>
#include <QLocale>

namespace limn {

QString translated(const Message& message) {
  if (message.kind() == Message::Kind::verbatim)
    return QString::fromStdString(message.text());
  if (message.kind() == Message::Kind::number) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(message.number(), 'f', message.decimals());
  }
  const QString pattern = QCoreApplication::translate("limn::Message", message.text().c_str());
  QString filled;
  // In one go: what stands in a place may hold a percent sign of its own.
  for (qsizetype i = 0; i < pattern.size(); ++i) {
    const int place =
        pattern[i] == QLatin1Char('%') && i + 1 < pattern.size() ? pattern[i + 1].digitValue() : 0;
    if (place < 1 || place > static_cast<int>(message.arguments().size())) {
      filled += pattern[i];
      continue;
    }
    filled += translated(message.arguments()[static_cast<std::size_t>(place - 1)]);
    ++i;
  }
  return filled;
}

} // namespace limn
