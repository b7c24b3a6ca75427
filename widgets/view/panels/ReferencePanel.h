// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QImage>

#include <vector>

class QLabel;

namespace limn {

/// Covers the view where the graphics driver failed: the pictures that the processor drew, side by side, and
/// below them why, with a way to try again and to copy what a report needs. The pointer reaches the view
/// through the pictures.
class ReferencePanel : public QWidget {
  Q_OBJECT

public:
  explicit ReferencePanel(QWidget* parent);

  /// `details`: what the driver wrote, for the clipboard.
  void setReason(const QString& sentence, const QString& details);
  void setPictures(const std::vector<QImage>& pictures);
  const std::vector<QImage>& pictures() const { return m_pictures; }

  /// Lays both parts over a rectangle of the parent.
  void cover(const QRect& rect);
  void showParts(bool visible);

signals:
  void retryRequested();

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void copyDetails() const;

  QFrame* m_bar = nullptr;
  QLabel* m_text = nullptr;
  QString m_sentence;
  QString m_details;
  std::vector<QImage> m_pictures;
};

} // namespace limn
