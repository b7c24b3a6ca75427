// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <optional>

namespace limn {

class TransferFunctionCanvas;

/// Tells whose reach shall be shown: the point of a curve on which the pointer rests for a moment, or the one
/// in hand after H; nothing once the pointer leaves it, a button is pressed, the curve changes or the focus
/// goes, and never during a drag.
class PointLight : public QObject {
  Q_OBJECT

public:
  explicit PointLight(TransferFunctionCanvas& canvas);

  std::optional<std::size_t> point() const { return m_lit; }
  void turnOff();

signals:
  void changed(std::optional<std::size_t> point);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void wait(std::optional<std::size_t> point);
  void light(std::optional<std::size_t> point);
  bool toggle();

  TransferFunctionCanvas& m_canvas;
  QTimer m_rest{this};
  std::optional<std::size_t> m_waiting; ///< on which the pointer rests
  std::optional<std::size_t> m_lit;
  bool m_isByKey = false;
};

} // namespace limn
