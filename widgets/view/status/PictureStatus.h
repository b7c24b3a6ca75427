// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/status/PictureStatusText.h"

#include <QWidget>

#include <array>

class QLabel;

namespace limn {

/// Says in the status bar how close the pictures come to the exact ones. Each part keeps its place while
/// numbers change; where the room is narrow, the parts that matter least are left out.
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
  std::array<int, 4> widths() const;
  void arrange();

  PictureStatusText m_text;
  std::array<QLabel*, 4> m_parts{}; ///< estimate, step, time, engine
  int m_padding = 0;                ///< that the style gives to a part
};

} // namespace limn
