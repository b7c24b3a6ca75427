// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>

#include <vector>

namespace limn {

/// What became of a file, and a sentence for each thing that is no longer as it was.
struct LookReportEntry {
  QString file;
  QString outcome; ///< "imported as "Bones"", "refused"
  QStringList sentences;
  bool isRefused = false;
};

/// Shows what changed or was lost when looks were imported or exported. Its text can be selected, by mouse
/// and keys, and copied as a whole. Never modal.
class LookReport : public QDialog {
  Q_OBJECT

public:
  LookReport(const QString& title, const QString& summary, const std::vector<LookReportEntry>& entries,
             QWidget* parent);

  /// All that it says, as it is copied.
  const QString& plainText() const { return m_plainText; }

private:
  QString m_plainText;
};

} // namespace limn
