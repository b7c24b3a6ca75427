// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/panels/PictureStatusText.h"

#include <QWidget>

#include <array>

class QLabel;
class QToolButton;

namespace limn {

/// Says in the status bar how close the pictures come to the exact ones: one badge, and behind it, when it is
/// pressed, levels and steps. Each part keeps its place while numbers change; where the room is narrow, the
/// parts that matter least are left out.
class PictureStatus : public QWidget {
  Q_OBJECT

public:
  explicit PictureStatus(QWidget* parent = nullptr);

  void setText(const PictureStatusText& text);
  const PictureStatusText& text() const { return m_text; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  static constexpr std::size_t partCount = 5;
  std::array<int, partCount> widths() const;
  void arrange();

  PictureStatusText m_text;
  QToolButton* m_badge;
  std::array<QLabel*, partCount - 1> m_labels{}; ///< estimate, step, time, engine
  std::array<QWidget*, partCount> m_parts{};     ///< the badge and those
  int m_padding = 0;                             ///< that the style gives to a part
};

} // namespace limn
