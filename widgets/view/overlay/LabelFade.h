// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/pictures/PictureState.h"

#include <QTimer>
#include <QVariantAnimation>

namespace limn {

/// How strongly the numbers of the labels show: fully for a few seconds, then they fade. Where the picture
/// they tell of takes longer than that, the seconds count from when it is complete.
class LabelFade : public QObject {
  Q_OBJECT

public:
  explicit LabelFade(QObject* parent = nullptr);

  void wake();
  void noteState(const PictureState& state);
  double opacity() const { return m_fade.currentValue().toDouble(); } ///< 0..1

signals:
  void changed();

private:
  void show();

  bool m_awaitsPicture = false;
  QVariantAnimation m_fade;
  QTimer m_stay;
};

} // namespace limn
