// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QVariantAnimation>

namespace limn {

/// How strongly the numbers of the labels show: fully for a few seconds, then they fade.
class LabelFade : public QObject {
  Q_OBJECT

public:
  explicit LabelFade(QObject* parent = nullptr);

  void wake();
  double opacity() const { return m_fade.currentValue().toDouble(); } ///< 0..1

signals:
  void changed();

private:
  QVariantAnimation m_fade;
  QTimer m_stay;
};

} // namespace limn
