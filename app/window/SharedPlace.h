// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

#include <memory>

namespace limn {

/// A panel in a place that it shares with others, which take turns behind tabs. Each asks for as much width
/// as the widest of them needs, so that the picture beside them stays as it is when the tab changes.
class SharedPlace : public QWidget {
public:
  /// Those that share one place.
  using Sharers = std::shared_ptr<QList<const QWidget*>>;

  /// Adds `panel` to `sharers` and takes it in.
  SharedPlace(QWidget& panel, const Sharers& sharers);

  QSize minimumSizeHint() const override;

private:
  Sharers m_sharers;
};

} // namespace limn
