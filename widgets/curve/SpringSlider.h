// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/LabelledRow.h"

#include <QLabel>
#include <QWidget>

#include <cstdint>
#include <functional>

namespace limn {

class TrackSlider;

/// A slider for relative changes: it springs back to its neutral place when let go. The number pulled to
/// shows while it is held, and as what was done until that is told to be over; otherwise there is none,
/// because a neutral one would be taken for what holds.
class SpringSlider : public QWidget {
  Q_OBJECT

public:
  /// `readOut` turns a pulled number into words.
  SpringSlider(const QString& label, const QString& help, const SliderScale& scale, double neutral,
               std::function<QString(double)> readOut, QWidget* parent = nullptr);

  /// Once the words for a number have become other ones: makes room for them.
  void measureNumber();
  /// What the last pull did has become something else.
  void forgetPull() { m_number->clear(); }

signals:
  /// Pulled away from neutral by so much; `gestureId` is shared by one pull.
  void pulled(double number, std::uint64_t gestureId);
  /// Let go: the next pull starts from what is now.
  void released();

private:
  SliderScale m_scale;
  std::function<QString(double)> m_readOut;
  QLabel* m_number;
  TrackSlider* m_slider;
};

} // namespace limn
