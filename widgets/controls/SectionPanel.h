// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

#include <vector>

namespace limn {

/// Parts of the window's business one below another; it scrolls down alone, and is never narrower than what
/// it holds needs beside the scroll bar.
class SectionPanel : public QScrollArea {
public:
  explicit SectionPanel(QWidget* parent = nullptr);

  /// Fills it with sections.
  void stack(const std::vector<QWidget*>& sections);

  /// Asked for anew whenever the panel is laid out: fonts and styles come later than panels.
  QSize minimumSizeHint() const override;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace limn
